"""Finds material parameters from measured displacements, with the table of a parameter study.

    python examples/identification/identify.py              # the figures
    python examples/identification/identify.py --check      # and whether they are right
    python examples/identification/identify.py --picture examples/identification/identification.png

Each output is fitted by a quadratic polynomial of the logarithms of the parameters, by least
squares over the cases of the study. The parameters for which these polynomials come nearest to the
measurement are found by Gauss and Newton's method. Needs numpy, the picture matplotlib.
"""

import argparse
import csv
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
PARAMETERS = ["young", "stiffness", "friction"]
OUTPUTS = ["brick_low", "brick_high", "top", "force"]
# the largest error of a parameter with which the check is passed
TOLERANCE = 0.05


def read(path):
    """Columns of a table by name, units left out; cases that failed are left out, too."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["status"] == "0"]
    names = [name.split(" (")[0] for name in rows[0]]
    return {name: np.array([float(list(row.values())[k]) for row in rows]) for k, name in enumerate(names)}


def terms(x):
    """1, x, and all products of two of x; one row for each row of x."""
    n = x.shape[1]
    products = [x[:, i] * x[:, j] for i in range(n) for j in range(i, n)]
    return np.column_stack([np.ones(len(x)), x, *products])


class Surfaces:
    """The outputs as polynomials of the logarithms of the parameters, scaled to -1 to 1."""

    def __init__(self, table):
        logs = np.log(np.column_stack([table[name] for name in PARAMETERS]))
        self.middle = 0.5 * (logs.max(axis=0) + logs.min(axis=0))
        self.half = 0.5 * (logs.max(axis=0) - logs.min(axis=0))
        self.x = self.scaled(logs)
        self.y = np.log(np.abs(np.column_stack([table[name] for name in OUTPUTS])))
        self.coefficients = self.fit(self.x, self.y)

    def scaled(self, logs):
        return (logs - self.middle) / self.half

    @staticmethod
    def fit(x, y):
        return np.linalg.lstsq(terms(x), y, rcond=None)[0]

    def at(self, x):
        return (terms(np.atleast_2d(x)) @ self.coefficients)[0]

    def errors(self):
        """Each case as the polynomials of the other cases have it, relative; root mean square."""
        found = []
        for k in range(len(self.x)):
            others = np.arange(len(self.x)) != k
            fitted = terms(self.x[k : k + 1]) @ self.fit(self.x[others], self.y[others])
            found.append(fitted[0] - self.y[k])
        return np.sqrt(np.mean(np.square(found), axis=0))

    def inverse(self, measured, weights):
        """The parameters whose outputs come nearest to the measurement."""
        target, x, step = np.log(np.abs(measured)), np.zeros(len(PARAMETERS)), 1e-6
        for _ in range(50):
            rest = (target - self.at(x)) * weights
            slopes = np.column_stack(
                [(self.at(x + step * e) - self.at(x - step * e)) / (2 * step) * weights for e in np.eye(len(x))]
            )
            change = np.linalg.lstsq(slopes, rest, rcond=None)[0]
            # the polynomials are of no use beyond the cases that they were made of
            x = np.clip(x + np.clip(change, -0.5, 0.5), -1, 1)
        return np.exp(self.middle + self.half * x)

    def slice(self, base, parameter, values):
        """An output for values of one parameter, the others at the base."""
        logs = np.log(np.tile(base, (len(values), 1)))
        logs[:, parameter] = np.log(values)
        return np.exp(terms(self.scaled(logs)) @ self.coefficients)


def picture(path, table, surfaces, found, measured):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    shown = [
        ("brick_high", 1e6, "uy of the brick (µm)"),
        ("top", 1e6, "uy at the top (µm)"),
        ("force", 1e-3, "force (kN)"),
    ]
    units = [1e-9, 1, 1]
    labels = ["Young's modulus of the brick (GPa)", "stiffness of the joints (factor)", "coefficient of friction"]
    ticks = [[8, 16, 32], [0.25, 0.5, 1, 2], [0.4, 0.5, 0.6, 0.7, 0.8, 0.9]]
    figure, axes = plt.subplots(3, 3, figsize=(10, 8), sharey="row", sharex="col", layout="constrained")
    for row, (output, factor, label) in enumerate(shown):
        index = OUTPUTS.index(output)
        for column, name in enumerate(PARAMETERS):
            ax, unit = axes[row][column], units[column]
            ax.plot(table[name] * unit, np.abs(table[output]) * factor, "o", ms=3, color="0.6", label="cases of the study")
            values = np.geomspace(table[name].min(), table[name].max(), 50)
            curve = surfaces.slice(found, column, values)[:, index]
            ax.plot(values * unit, curve * factor, color="#2166ac", label="fitted, the others as found")
            ax.axhline(abs(measured[index]) * factor, color="#d7191c", lw=1, label="measured")
            ax.axvline(found[column] * unit, color="#d7191c", lw=1, ls=":", label="found")
            ax.set_xscale("log")
            ax.set_xticks(ticks[column], [f"{tick:g}" for tick in ticks[column]])
            ax.minorticks_off()
            if column == 0:
                ax.set_ylabel(label)
            if row == 2:
                ax.set_xlabel(labels[column])
    figure.legend(*axes[0][0].get_legend_handles_labels(), loc="outside upper center", ncols=4)
    figure.savefig(path, dpi=110)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--check", action="store_true", help="fail if the known parameters are not found")
    arguments.add_argument("--picture", type=Path, help="draw the study and the measurement")
    arguments = arguments.parse_args()
    table, truth = read(HERE / "results.csv"), read(HERE / "measured.csv")
    surfaces = Surfaces(table)
    errors = surfaces.errors()
    print(f"{len(surfaces.x)} cases; root mean square error of the polynomials, each case left out once:")
    for name, error in zip(OUTPUTS, errors):
        print(f"  {name:<12} {100 * error:6.2f} %")
    measured = np.array([truth[name][0] for name in OUTPUTS])
    known = np.array([truth[name][0] for name in PARAMETERS])
    # outputs count as much as they are known well
    found = surfaces.inverse(measured, 1 / errors)
    print("measured without error:")
    for name, k, f in zip(PARAMETERS, known, found):
        print(f"  {name:<16} known {k:.4g}  found {f:.4g}  ({100 * (f / k - 1):+.2f} %)")
    # what an error of 1 % in each measurement does
    random = np.random.default_rng(1)
    noise = 1 + 0.01 * random.standard_normal((200, len(OUTPUTS)))
    weights = 1 / np.hypot(errors, 0.01)
    spread = np.std([np.log(surfaces.inverse(measured * n, weights)) for n in noise], axis=0)
    print("200 measurements with errors of 1 %, standard deviation of what is found:")
    for name, s in zip(PARAMETERS, spread):
        print(f"  {name:<16} {100 * s:6.2f} %")
    if arguments.picture:
        picture(arguments.picture, table, surfaces, found, measured)
    worst = np.max(np.abs(found / known - 1))
    if arguments.check and worst > TOLERANCE:
        sys.exit(f"a parameter is {100 * worst:.1f} % off, more than {100 * TOLERANCE:.0f} %")


if __name__ == "__main__":
    main()
