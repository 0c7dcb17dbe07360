"""A forge that stores commit statuses in a file, so that it can be killed.

Requests are checked as GitHub's REST description has them: `POST /repos/{owner}/{repo}/statuses/{sha}` with a `state`
out of four, optional texts, and no more than 140 characters of description (its documented limit).
"""

import argparse
import json
import os
import random
import re
import sys
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

POST = re.compile(r"/repos/([\w.-]+/[\w.-]+)/statuses/([0-9a-f]{40})")
LIST = re.compile(r"/repos/([\w.-]+/[\w.-]+)/commits/([0-9a-f]{40})/statuses(?:\?.*)?")
STATES = {"error", "failure", "pending", "success"}
FIELDS = {"state", "target_url", "description", "context"}
MOST_DESCRIPTION = 140
MOST_SHOWN = 100


def problem_of(body):
    """Why GitHub would refuse a body; empty if it would not."""
    if not isinstance(body, dict) or set(body) - FIELDS:
        return "unknown fields"
    if body.get("state") not in STATES:
        return "state"
    if not all(isinstance(text, str) for text in body.values()):
        return "a field is not a text"
    if len(body.get("description", "")) > MOST_DESCRIPTION:
        return "description"
    if not re.match(r"https?://", body.get("target_url", "")):
        return "target_url"
    return ""


class Store:
    """The statuses, also of the forge before it was killed."""

    def __init__(self, file):
        self.file, self.lock = file, threading.Lock()
        file.touch()
        # A kill can leave a part of the last line; its request was not answered.
        text = file.read_bytes()
        os.truncate(file, text.rfind(b"\n") + 1)

    def read(self):
        with self.lock:
            return [json.loads(line) for line in self.file.read_text().splitlines()]

    def add(self, entry):
        with self.lock, self.file.open("a") as out:
            out.write(json.dumps(entry) + "\n")
            out.flush()
            os.fsync(out.fileno())


def handler(store, token, lose, rng):
    class Handler(BaseHTTPRequestHandler):
        def do_POST(self):
            body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
            found = POST.fullmatch(self.path)
            if self.is_refused(found):
                return
            try:
                status = json.loads(body)
                problem = problem_of(status)
            except ValueError:
                status, problem = {}, "no JSON"
            if problem:
                store.add({"problem": f"{problem}: {body.decode(errors='replace')}"})
                self.answer(422, {"message": "Validation Failed"})
                return
            store.add({"sha": found.group(2), **status})
            if rng.random() < lose:
                # Stored, but the connection ends without an answer.
                self.close_connection = True
                return
            self.answer(201, {"id": 1, **status})

        def do_GET(self):
            found = LIST.fullmatch(self.path)
            if not self.is_refused(found):
                of = [entry for entry in store.read() if entry.get("sha") == found.group(2)]
                self.answer(200, of[::-1][:MOST_SHOWN])

        def is_refused(self, found):
            if self.headers.get("Authorization") != f"Bearer {token}":
                self.answer(401, {"message": "Bad credentials"})
                return True
            if not found:
                store.add({"problem": f"no such operation: {self.command} {self.path}"})
                self.answer(404, {"message": "Not Found"})
                return True
            return False

        def answer(self, code, content):
            data = json.dumps(content).encode()
            self.send_response(code)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(data)))
            self.end_headers()
            self.wfile.write(data)

        def log_message(self, *_):
            pass

    return Handler


def end_with_stdin():
    sys.stdin.buffer.read()
    os._exit(0)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("port", type=int)
    parser.add_argument("file", type=Path)
    parser.add_argument("--lose", type=float, default=0.02, help="share of the answers that are lost")
    given = parser.parse_args()
    threading.Thread(target=end_with_stdin, daemon=True).start()
    answers = handler(Store(given.file), os.environ["FORGE_TOKEN"], given.lose, random.Random())
    with ThreadingHTTPServer(("127.0.0.1", given.port), answers) as server:
        print(f"listening {server.server_address[1]}", flush=True)
        server.serve_forever()


if __name__ == "__main__":
    main()
