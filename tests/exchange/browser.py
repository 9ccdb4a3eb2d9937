"""Has headless Chromium load a model in avatar.html, from a server of this machine alone."""
import http.server
import json
import shutil
import subprocess
import threading

PATIENCE = 240  # Seconds.


class Handler(http.server.SimpleHTTPRequestHandler):
    """Serves the page, the model and the packages; takes the result."""

    def translate_path(self, path):
        return str(self.server.files.get(path, self.server.packages / path.split("?")[0].lstrip("/")))

    def do_POST(self):
        self.server.found = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        self.send_response(204)
        self.end_headers()
        self.server.done.set()

    def log_message(self, *words):
        pass


def seen_in_browser(page, model, folder):
    """What the page sends; `folder` has node_modules, and gets the browser's own files."""
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    server.files, server.packages = {"/": page, "/model.glb": model}, folder
    server.found, server.done = {"error": "the page sent nothing"}, threading.Event()
    Handler.extensions_map = Handler.extensions_map | {".html": "text/html", ".js": "text/javascript"}
    threading.Thread(target=server.serve_forever, daemon=True).start()
    profile = folder / "browser"
    browser = subprocess.Popen(
        ["chromium", "--headless", "--no-sandbox", "--disable-background-networking", "--disable-component-update",
         "--no-first-run", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", f"--user-data-dir={profile}",
         f"http://127.0.0.1:{server.server_address[1]}/"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    server.done.wait(PATIENCE)
    browser.terminate()
    browser.wait()
    server.shutdown()
    shutil.rmtree(profile, ignore_errors=True)
    return server.found
