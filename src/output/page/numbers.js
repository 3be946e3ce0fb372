// Exact numbers as text, their decimals, and arrays in base64.
// SPDX-License-Identifier: GPL-3.0-or-later

/** A ratio "a/b" as the nearest number, or next to it. */
function value(ratio) {
  const [over, under = "1"] = ratio.split("/");
  if (over.length < 300 && under.length < 300) return Number(over) / Number(under);
  const shift = BigInt(Math.max(0, under.length - over.length + 20) * 4);
  return Number((BigInt(over) << shift) / BigInt(under)) / Math.pow(2, Number(shift));
}

/** A ratio rounded to `digits` digits, ties to even, written as Graze does; `exact` if the decimal is the number itself. */
function decimal(ratio, digits) {
  const [over, under = "1"] = ratio.split("/");
  const negative = over.startsWith("-"), b = BigInt(under);
  const a = BigInt(negative ? over.slice(1) : over), ten = 10n;
  if (a === 0n) return {text: "0", exact: true};
  // The exponent e with 10^(e-1) <= a/b < 10^e.
  let e = a.toString().length - under.length;
  const below = (k) => (k >= 0 ? a < b * ten ** BigInt(k) : a * ten ** BigInt(-k) < b);
  while (!below(e)) e += 1;
  while (below(e - 1)) e -= 1;
  const up = digits - e;
  const top = up >= 0 ? a * ten ** BigInt(up) : a, bottom = up >= 0 ? b : b * ten ** BigInt(-up);
  let whole = top / bottom;
  const twice = 2n * (top % bottom), exact = twice === 0n;
  if (twice > bottom || (twice === bottom && whole % 2n === 1n)) whole += 1n;
  let figures = whole.toString();
  if (figures.length > digits) {
    figures = figures.slice(0, digits);
    e += 1;
  }
  if (exact) figures = figures.replace(/0+$/, "");
  return {text: (negative ? "-" : "") + layout(figures, e, digits), exact};
}

/** The text of 0.FIGURES * 10^e, with an exponent where the text would be long without it. */
function layout(figures, e, digits) {
  if (e > digits || e < -4) {
    const rest = figures.slice(1);
    return figures[0] + (rest ? "." + rest : "") + "e" + (e - 1);
  }
  if (e <= 0) return "0." + "0".repeat(-e) + figures;
  if (figures.length <= e) return figures + "0".repeat(e - figures.length);
  return figures.slice(0, e) + "." + figures.slice(e);
}

/** The difference of two numbers, ratios or decimals, as a ratio in lowest terms. */
function difference(x, y) {
  const parts = (text) => {
    const [over, under = "1"] = text.split("/"), [digits, power = "0"] = over.split("e"), [whole, rest = ""] = digits.split(".");
    const scale = Number(power) - rest.length;
    return [BigInt(whole + rest) * 10n ** BigInt(Math.max(0, scale)), BigInt(under) * 10n ** BigInt(Math.max(0, -scale))];
  };
  const [a, b] = parts(x), [c, d] = parts(y);
  let over = a * d - c * b, under = b * d, [g, h] = [over < 0n ? -over : over, under];
  while (h) [g, h] = [h, g % h];
  [over, under] = [over / g, under / g];
  return under === 1n ? String(over) : `${over}/${under}`;
}

function bytes(base64) {
  const text = atob(base64), out = new Uint8Array(text.length);
  for (let k = 0; k < text.length; k++) out[k] = text.charCodeAt(k);
  return out.buffer;
}

const octets = (base64) => new Uint8Array(bytes(base64));
const floats = (base64) => new Float32Array(bytes(base64));
const doubles = (base64) => new Float64Array(bytes(base64));
const counts = (base64) => new Uint32Array(bytes(base64));
