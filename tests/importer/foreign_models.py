#!/usr/bin/python3
"""Gives every file of a folder to `hairpaint new --head`: each is loaded, or refused in one sentence that names it.

    foreign_models.py PROGRAM FOLDER

None may take over 20 s or, with its helper, 2 GB. Prints a line for each that does otherwise, the slowest and the
largest, and ends with "N passed, M failed".
"""
import subprocess
import sys
import tempfile
import time
from pathlib import Path

MOST_SECONDS = 20.0
MOST_BYTES = 2_000_000_000


def resident_bytes(pid):
    """Of a process and its children; 0 where it is gone."""
    try:
        own = int(Path(f"/proc/{pid}/statm").read_text().split()[1]) * 4096
        children = Path(f"/proc/{pid}/task/{pid}/children").read_text().split()
        return own + sum(resident_bytes(child) for child in children)
    except (OSError, IndexError):
        return 0


def problem_of(code, error, path):
    """Empty where all is well."""
    if code == 0:
        return "" if error == "" else f"said {error!r}"
    if code != 1:
        return f"ended with {code}"
    one_sentence = error.count("\n") == 1 and error.endswith(".\n") and path.name in error
    return "" if one_sentence else f"said {error!r}"


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    rows = []
    with tempfile.TemporaryDirectory() as made:
        for path in sorted(file for file in folder.rglob("*") if file.is_file()):
            begin = time.monotonic()
            run = subprocess.Popen([program, "new", "--head", str(path), "-o", f"{made}/head.hairpaint"],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            peak = 0
            while run.poll() is None:
                peak = max(peak, resident_bytes(run.pid))
                time.sleep(0.01)
                if time.monotonic() - begin > 3 * MOST_SECONDS:
                    run.kill()
            seconds = time.monotonic() - begin
            problem = problem_of(run.returncode, run.stderr.read().decode(errors="backslashreplace"), path)
            if seconds > MOST_SECONDS or peak > MOST_BYTES:
                problem += f" took {seconds:.1f} s and {peak / 1e6:.0f} MB"
            if problem:
                print(f"{path}: {problem}")
            rows.append((seconds, peak, path, run.returncode == 0, problem == ""))
    if rows:
        slowest, largest = max(rows, key=lambda row: row[0]), max(rows, key=lambda row: row[1])
        print(f"{sum(row[3] for row in rows)} of {len(rows)} loaded; slowest {slowest[0]:.1f} s ({slowest[2].name}), "
              f"largest {largest[1] / 1e6:.0f} MB ({largest[2].name})")
    passed = sum(row[4] for row in rows)
    print(f"{passed} passed, {len(rows) - passed} failed")
    return 0 if rows and passed == len(rows) else 1


if __name__ == "__main__":
    sys.exit(main())
