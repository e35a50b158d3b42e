"""Drives Chromium without a window by its DevTools protocol over two pipes; needs Python's standard library alone."""

import base64
import contextlib
import json
import os
import pathlib
import select
import shutil
import subprocess
import tempfile
import time

from pixels import Pixels

PATIENCE = 120  # seconds for an answer; a busy machine draws slowly

ARGUMENTS = [
    "--headless", "--no-sandbox", "--disable-dev-shm-usage", "--disable-extensions", "--hide-scrollbars",
    # Drawn by the processor, so that it is the same everywhere.
    "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--force-color-profile=srgb",
    "--host-resolver-rules=MAP * ~NOTFOUND", "--window-size=800,600", "--remote-debugging-pipe", "about:blank",
]


class Chromium:
    """A browser with one page. Everything that the page says on its console is kept in `messages`."""

    def __init__(self, program):
        self.profile = tempfile.mkdtemp(prefix="gnomon-chromium-")
        to_browser, self.out = os.pipe()
        self.inp, from_browser = os.pipe()

        def use_pipes():  # Chromium reads from 3 and writes to 4
            ends = [os.dup(to_browser), os.dup(from_browser)]
            for place, end in zip((3, 4), ends):
                os.dup2(end, place)

        self.process = subprocess.Popen([program, f"--user-data-dir={self.profile}", *ARGUMENTS], pass_fds=(3, 4),
                                        preexec_fn=use_pipes, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.buffer = b""
        self.count = 0
        self.session = None
        self.messages = []
        self._attach()

    def _attach(self):
        targets = self.call("Target.getTargets")["targetInfos"]
        page = next(target for target in targets if target["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.call(domain + ".enable")
        self.call("Emulation.setDeviceMetricsOverride", width=800, height=600, deviceScaleFactor=1, mobile=False)

    def close(self):
        with contextlib.suppress(OSError, RuntimeError):
            self.session = None
            self.call("Browser.close")
        try:
            self.process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.out)
        os.close(self.inp)
        shutil.rmtree(self.profile, ignore_errors=True)

    # --- the protocol -------------------------------------------------------------------------------------------------

    def _next(self, until):
        while b"\0" not in self.buffer:
            if not select.select([self.inp], [], [], max(0.0, until - time.monotonic()))[0]:
                raise RuntimeError("Chromium does not answer")
            more = os.read(self.inp, 1 << 20)
            if not more:
                raise RuntimeError("Chromium has ended")
            self.buffer += more
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def _note(self, event):
        """Keeps what a person would find on the console."""
        what, said = event.get("method"), event.get("params", {})
        if what == "Runtime.consoleAPICalled":
            self.messages.append(" ".join(str(part.get("value", part.get("description"))) for part in said["args"]))
        elif what == "Log.entryAdded":
            self.messages.append(said["entry"]["text"])
        elif what == "Runtime.exceptionThrown":
            self.messages.append(said["exceptionDetails"].get("exception", {}).get("description", "an exception"))

    def call(self, method, **parameters):
        self.count += 1
        request = {"id": self.count, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        os.write(self.out, json.dumps(request).encode() + b"\0")
        until = time.monotonic() + PATIENCE
        while True:
            answer = self._next(until)
            self._note(answer)
            if answer.get("id") == self.count:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']['message']}")
                return answer["result"]

    # --- what a person does -------------------------------------------------------------------------------------------

    def open(self, file):
        """Opens a page and waits until it has drawn."""
        self.messages.clear()
        self.call("Page.navigate", url=pathlib.Path(file).resolve().as_uri())
        self.settle()

    def settle(self):
        """Waits until the page says that its picture rests."""
        until = time.monotonic() + PATIENCE
        while time.monotonic() < until:
            if self.value("document.readyState === 'complete' && Boolean(document.documentElement.dataset.drawn)"):
                return
            time.sleep(0.05)
        raise RuntimeError("the page is not drawn; its console: " + "; ".join(self.messages))

    def value(self, expression):
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(expression + ": " + answer["exceptionDetails"]["exception"]["description"])
        return answer["result"].get("value")

    def _mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def move(self, x, y):
        self._mouse("mouseMoved", x, y)

    def drag(self, start, end, steps=4):
        self.move(*start)
        self._mouse("mousePressed", *start, button="left", buttons=1, clickCount=1)
        for k in range(1, steps + 1):
            x, y = (a + (b - a) * k / steps for a, b in zip(start, end))
            self._mouse("mouseMoved", x, y, button="left", buttons=1)
        self._mouse("mouseReleased", *end, button="left", buttons=0, clickCount=1)
        self.settle()

    def click(self, selector):
        """Presses the middle of the first element of a CSS selector."""
        box = self.value(f"(b => b && [b.x + b.width / 2, b.y + b.height / 2])"
                         f"(document.querySelector({json.dumps(selector)})?.getBoundingClientRect())")
        if not box:
            raise RuntimeError("no element " + selector)
        for kind, buttons in (("mousePressed", 1), ("mouseReleased", 0)):
            self._mouse(kind, *box, button="left", buttons=buttons, clickCount=1)
        self.settle()

    def wheel(self, x, y, down):
        self._mouse("mouseWheel", x, y, deltaX=0, deltaY=down)
        self.settle()

    def key(self, key):
        text = {"text": key} if len(key) == 1 else {}
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, **text)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key)
        self.settle()

    def screenshot(self):
        return Pixels(base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"]))
