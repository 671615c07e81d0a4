"""Compares a run of the masonry deck with the results of the original program.

    python compare_masonry.py RUN_DIR REFERENCE_DIR

RUN_DIR holds `actual` (d3plot) and `actual.yh0` as the run wrote them, REFERENCE_DIR
`actual.d3plot` and `actual.yh0` of the original. Histories are compared line by line, d3plot
files word by word of the header and array by array of every state. The files are parsed here
with nothing but numpy: other readers refuse the original's header. Prints the largest
differences; exits with 1 when one is larger than allowed.
"""

import sys
from pathlib import Path

import numpy as np

# 9 digits of a history value, and what the d3plot's single precision leaves
HISTORY_TOLERANCE = 1e-9
STATE_TOLERANCE = 1e-6

HEADER_WORDS = 64
TITLE_WORDS = range(10)
FILE_TYPE, SHELL_STRESSES = 11, 43
# header words that are meant to differ: the title has the date; 11 and 43 are mended
MENDED = {*TITLE_WORDS, FILE_TYPE, SHELL_STRESSES}
NUMNP, NGLBV, NEL4, NV2D = 16, 18, 31, 33
END_OF_FILE = -999999.0


class Report:
    """Prints what was compared and remembers whether all of it was good."""

    def __init__(self):
        self.good = True

    def line(self, what, count, difference, scale, tolerance):
        relative = difference / scale if scale else difference
        good = relative <= tolerance
        self.good &= good
        mark = "" if good else "  <-- too large"
        print(f"{what:34} {count:9d} values, largest {scale:.6e}, largest difference {difference:.3e}, relative {relative:.3e}{mark}")

    def arrays(self, what, found, expected, tolerance):
        found, expected = found.astype(float), expected.astype(float)
        if found.shape != expected.shape:
            self.fail(f"{what}: shape {found.shape}, but {expected.shape} expected")
            return
        # NaN is never good: it does not compare
        difference = np.nan_to_num(np.abs(found - expected), nan=np.inf).max(initial=0.0)
        self.line(what, found.size, difference, np.abs(expected).max(initial=0.0), tolerance)

    def fail(self, text):
        self.good = False
        print(f"FAILED: {text}")


def read_d3plot(path):
    """Header words, geometry words, and a mapping of arrays over all states of one file."""
    words = np.fromfile(path, dtype="<i4")
    header = words[:HEADER_WORDS]
    nodes, globals_, shells, per_shell = (int(header[i]) for i in (NUMNP, NGLBV, NEL4, NV2D))
    geometry = HEADER_WORDS + 3 * nodes + 5 * shells
    sizes = {
        "time": 1,
        "kinetic energy": 1,
        "other globals": globals_ - 1,
        "coordinates": 3 * nodes,
        "velocities": 3 * nodes,
        "accelerations": 3 * nodes,
        "stresses": per_shell * shells,
        "element table": shells,
    }
    record = sum(sizes.values())
    states = words[geometry:].view("<f4")
    if len(states) % record == 1 and states[-1] == END_OF_FILE:
        states = states[:-1]
    if len(states) % record:
        raise SystemExit(f"{path}: {len(states)} words are no whole number of states of {record}")
    parts = np.split(states.reshape(-1, record), np.cumsum(list(sizes.values()))[:-1], axis=1)
    return header, words[HEADER_WORDS:geometry], dict(zip(sizes, parts))


def compare_d3plot(report, run, reference):
    header, geometry, states = read_d3plot(run)
    header0, geometry0, states0 = read_d3plot(reference)
    odd = [i for i in range(HEADER_WORDS) if header[i] != header0[i] and i not in MENDED]
    if odd:
        report.fail(f"d3plot: header words {odd} differ")
    for word in (FILE_TYPE, SHELL_STRESSES):
        print(f"header word {word}: {header[word]}, the original's {header0[word]} (known)")
    report.arrays("d3plot: geometry", geometry, geometry0, 0.0)
    for name, expected in states0.items():
        report.arrays(f"d3plot: {name}", states[name], expected, STATE_TOLERANCE)
    # once more state by state, so that early small values are not hidden behind late large ones
    worst, differing = 0.0, 0.0
    for name in ("coordinates", "velocities", "stresses"):
        for found, expected in zip(states[name].astype(float), states0[name].astype(float)):
            scale = np.abs(expected).max()
            if scale > 0:
                worst = max(worst, np.nan_to_num(np.abs(found - expected), nan=np.inf).max() / scale)
                differing = max(differing, float((found != expected).mean()))
    report.line("d3plot: worst relative, per state", len(states0["time"]), worst, 1.0, STATE_TOLERANCE)
    print(f"at most {100 * differing:.3f} % of the words of an array of a state differ in any bit")


def compare_histories(report, run, reference):
    lines, lines0 = (Path(path).read_text().splitlines() for path in (run, reference))
    if len(lines) != len(lines0):
        report.fail(f"history: {len(lines)} lines, but {len(lines0)} expected")
        return
    identical = sum(a == b for a, b in zip(lines, lines0))
    print(f"history: {identical} of {len(lines0)} lines are identical, letter for letter")
    values, values0 = (np.array([line.split() for line in which], float) for which in (lines, lines0))
    scale = np.maximum(np.abs(values0), 1e-300)
    relative = np.where(values == values0, 0.0, np.abs(values - values0) / scale)
    worst = np.nan_to_num(relative, nan=np.inf).max()
    report.line("history: worst relative, per line", values0.size, worst, 1.0, HISTORY_TOLERANCE)


def main():
    run, reference = (Path(argument) for argument in sys.argv[1:3])
    report = Report()
    compare_histories(report, run / "actual.yh0", reference / "actual.yh0")
    compare_d3plot(report, run / "actual", reference / "actual.d3plot")
    sys.exit(0 if report.good else 1)


if __name__ == "__main__":
    main()
