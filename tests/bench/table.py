"""The table of the measurements: one line a row, printed as it is measured.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import json

COLUMNS = (f"{'work':76}{'required':>12}{'reached':>11}{'':5}{'Graze':>11}{'peer':>11}"
           f"{'p50':>10}{'p99':>10}{'max':>11}")


def micro(seconds):
    return "" if seconds is None else f"{seconds * 1e6:.2f}"


class Table:
    def __init__(self):
        self.rows = []

    def head(self, text):
        print(f"\n{text}\n{COLUMNS}", flush=True)

    def row(self, work, value, most=None, least=None, unit="x", graze=None, peer=None, each=None):
        """Print a row. `most` or `least` is what `value` must keep to, neither where it is only for information;
        `graze` and `peer` are seconds a query, `each` has p50, p99 and max."""
        required = f"<= {most:g}{unit}" if most is not None else f">= {least:g}{unit}" if least is not None else ""
        good = None
        if required and value is not None:
            good = value <= most if most is not None else value >= least
        mark = {None: "", True: " yes", False: " NO"}[good]
        each = each or {}
        shown = "unknown" if value is None else f"{value:.3g}{unit}" if abs(value) < 100 else f"{value:,.0f}{unit}"
        print(f"{work:76}{required:>12}{shown:>11}{mark:5}{micro(graze):>11}{micro(peer):>11}"
              f"{micro(each.get('p50')):>10}{micro(each.get('p99')):>10}{micro(each.get('max')):>11}", flush=True)
        self.rows.append({"work": work, "most": most, "least": least, "value": value, "unit": unit,
                          "reached": good, "graze": graze, "peer": peer, "each": each})

    def note(self, text):
        print(f"  {text}", flush=True)

    def end(self, path):
        judged = [r for r in self.rows if r["reached"] is not None]
        unknown = sum(r["value"] is None for r in self.rows)
        print(f"\n{sum(r['reached'] for r in judged)} of {len(judged)} requirements reached, {unknown} unknown")
        if path:
            with open(path, "w", encoding="utf-8") as file:
                json.dump(self.rows, file, indent=1)
