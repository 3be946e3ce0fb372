"""A headless Chromium driven through a pair of pipes by its debugging protocol.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import base64
import json
import os
import select
import signal
import subprocess
import tempfile
import time

from harness import bounded

PROGRAMS = ("chromium", "chromium-browser", "google-chrome")
OPTIONS = ("--headless=new", "--no-sandbox", "--remote-debugging-pipe", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
           "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
           "--disable-default-apps", "--disable-extensions", "--disable-dev-shm-usage", "--hide-scrollbars", "--mute-audio")
SECONDS = 100  # for one answer


class Chromium:
    """One browser with one page. `events` are those that came since the page was opened."""

    def __init__(self, width=1400, height=800):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        ours, self.out = os.pipe()
        self.back, theirs = os.pipe()
        words = [*OPTIONS, f"--window-size={width},{height}", f"--user-data-dir={self.folder.name}", "about:blank"]
        start = f'for p in {" ".join(PROGRAMS)}; do command -v $p >/dev/null && exec $p "$@" 3<&{ours} 4>&{theirs}; done; exit 127'
        environment = dict(os.environ, HOME=self.folder.name)
        self.process = subprocess.Popen(bounded(["bash", "-c", start, "bash", *words]), pass_fds=(ours, theirs), env=environment,
                                        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                        start_new_session=True)
        os.close(ours)
        os.close(theirs)
        self.number, self.rest, self.events, self.session = 0, b"", [], None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(domain + ".enable")
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def message(self, until):
        """The next message of the browser."""
        while b"\0" not in self.rest:
            if not select.select([self.back], [], [], max(0, until - time.monotonic()))[0]:
                raise TimeoutError("Chromium does not answer")
            some = os.read(self.back, 1 << 20)
            if not some:
                raise ConnectionError("Chromium ended; is it installed?")
            self.rest += some
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, **parameters):
        self.number += 1
        what = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            what["sessionId"] = self.session
        data = json.dumps(what).encode() + b"\0"
        while data:
            data = data[os.write(self.out, data):]
        until = time.monotonic() + SECONDS
        while True:
            answer = self.message(until)
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]
            if "method" in answer:
                self.events.append(answer)

    def value(self, expression):
        """The value of an expression of JavaScript; a promise is waited for."""
        done = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in done:
            raise RuntimeError(f"{expression}: {done['exceptionDetails']}")
        return done["result"].get("value")

    def open(self, path):
        """Open a file and wait until it says that it is ready; 1 if it does."""
        self.events = []
        self.call("Page.navigate", url="file://" + os.path.abspath(path))
        until = time.monotonic() + SECONDS
        while time.monotonic() < until:
            here = self.value("document.documentElement ? [location.pathname, document.documentElement.dataset.ready] : []")
            if here == [os.path.abspath(path), "yes"]:
                return 1
            time.sleep(.05)
        return 0

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def key(self, name):
        """Press a key by its name in the DOM; a letter writes itself."""
        text = {"text": name} if len(name) == 1 else {}
        self.call("Input.dispatchKeyEvent", type="keyDown", key=name, **text)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=name)

    def screenshot(self, path):
        with open(path, "wb") as file:
            file.write(base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"]))

    def faults(self):
        """Errors that the page or the browser reported, and addresses other than files that were asked for."""
        out = []
        for event in self.events:
            what = event.get("params", {})
            if event["method"] == "Runtime.exceptionThrown":
                out.append(what["exceptionDetails"])
            if event["method"] == "Runtime.consoleAPICalled" and what["type"] in ("error", "assert"):
                out.append(what["args"])
            if event["method"] == "Log.entryAdded" and what["entry"]["level"] == "error":
                out.append(what["entry"])
            if event["method"] == "Network.requestWillBeSent" and not what["request"]["url"].startswith(("file:", "data:", "blob:")):
                out.append(what["request"]["url"])
        return out

    def close(self):
        """End the processes that were started here."""
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self.process.wait()
        os.close(self.out)
        os.close(self.back)
        self.folder.cleanup()
