"""Reads the outputs of a run with other people's readers and compares the values.

The d3plot family is opened with lasso-python, every grid of the collection with VTK and with
meshio. What they read is compared with the full-precision states of the same run, with each
other, and with the collection. Prints a table of largest differences; exits with 1 when one is
larger than allowed or something does not fit together.

A state file `<base>.state_<N>.txt` holds the state after N completed steps. Outputs of step
index N are written after that step's forces and before its update: they show the coordinates
and velocities of state N and the forces of state N + 1. There is no state 0: the outputs of the
first step are compared in their forces only. The step index of an output is the number that ends
the name of its grid.
"""

import argparse
import re
import sys
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

import meshio
import numpy as np
from lasso.dyna import D3plot
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

VTK_LINE, VTK_TRIANGLE, VTK_TETRA = 3, 5, 10
CORNERS = {VTK_TRIANGLE: 3, VTK_TETRA: 4}
BROKEN = 2
STRESS = "Cauchy stress"
# in a plane d3plot the components other than XX, YY and XY are 0
PLANE = [0, 1, 3]


class Checks:
    """Collects largest differences and failures."""

    def __init__(self, tolerance):
        self.tolerance = tolerance
        self.rows = {}
        self.failures = []

    def fail(self, text):
        self.failures.append(text)

    def same(self, what, found, expected):
        if found != expected:
            self.fail(f"{what}: {found}, but {expected} expected")

    def close(self, what, found, expected):
        """Compares arrays relative to the largest expected value; NaN matches NaN."""
        found, expected = np.asarray(found), np.asarray(expected)
        if found.shape != expected.shape:
            self.fail(f"{what}: shape {found.shape}, but {expected.shape} expected")
            return
        entries, difference, scale, values, _ = self.rows.get(what, (0, 0.0, 0.0, 0, True))
        if found.size:
            finite = np.isfinite(expected)
            if not np.array_equal(found[~finite], expected[~finite], equal_nan=True):
                self.fail(f"{what}: not the same values are infinite or NaN")
            if finite.any():
                found = found[finite].astype(float)
                expected = expected[finite].astype(float)
                # A reader that yields NaN for a number must not pass.
                here = np.max(np.nan_to_num(np.abs(found - expected), nan=np.inf))
                difference = max(difference, float(here))
                scale = max(scale, float(np.max(np.abs(expected))))
        good = difference <= self.tolerance * scale
        self.rows[what] = (entries + 1, difference, scale, values + found.size, good)

    def report(self):
        width = max([len(what) for what in self.rows], default=10)
        print(f"{'compared':{width}}  outputs     values  largest value  largest difference")
        for what, (entries, difference, scale, values, good) in self.rows.items():
            mark = "" if good else "  <-- too large"
            print(f"{what:{width}}  {entries:7d}  {values:9d}  {scale:13.6e}  {difference:18.6e}{mark}")
            if not good:
                self.failures.append(f"{what}: difference {difference:.3e} of {scale:.3e}")
        for failure in self.failures:
            print(f"FAILED: {failure}")
        return 1 if self.failures else 0


class State(NamedTuple):
    """A state file; vectors have three components."""

    coordinates: np.ndarray
    velocities: np.ndarray
    forces: np.ndarray
    masses: np.ndarray
    flags: np.ndarray
    sets: np.ndarray
    elements: np.ndarray


def read_state(path):
    """The nodes and the elements of a state file."""
    nodes, elements = [], []
    rows = nodes
    with open(path, encoding="ascii") as lines:
        for line in lines:
            if line.startswith("# element"):
                rows = elements
            elif not line.startswith("#") and line.strip():
                rows.append([float(number) for number in line.split()])
    nodes, elements = np.array(nodes), np.array(elements, dtype=int)
    # id, then position, velocity and force, then mass, boundary flag and property
    dimensions = (nodes.shape[1] - 4) // 3
    vectors = [nodes[:, 1 + i * dimensions : 1 + (i + 1) * dimensions] for i in range(3)]
    missing = np.zeros((len(nodes), 3 - dimensions))
    vectors = [np.hstack([vector, missing]) for vector in vectors]
    # id, property, nodes
    return State(*vectors, *nodes[:, -3:].T, elements[:, 2:])


def read_collection(path):
    """Per time: step index, and the grid of each part."""
    outputs = {}
    for entry in ElementTree.parse(path).getroot().iter("DataSet"):
        file = path.parent / entry.get("file")
        step = re.search(r"_(\d+)$", file.stem)
        if step is None:
            raise SystemExit(f"{file} does not end with a step index")
        key = (float(entry.get("timestep")), int(step.group(1)))
        outputs.setdefault(key, {})[int(entry.get("part"))] = file
    return sorted(outputs.items())


def read_with_vtk(path):
    """The grid as arrays, by VTK's own reader."""
    reader = vtkXMLUnstructuredGridReader()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("error"))
    reader.SetFileName(str(path))
    reader.Update()
    if errors:
        raise SystemExit(f"VTK cannot read {path}")
    grid = reader.GetOutput()

    def arrays(data):
        names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
        return {name: vtk_to_numpy(data.GetArray(name)) for name in names}

    cells = grid.GetCells()
    tensors = grid.GetCellData().GetArray(STRESS)
    return {
        "points": vtk_to_numpy(grid.GetPoints().GetData()),
        "point": arrays(grid.GetPointData()),
        "cell": arrays(grid.GetCellData()),
        "field": arrays(grid.GetFieldData()),
        "types": vtk_to_numpy(grid.GetCellTypes()) if grid.GetNumberOfCells() else np.zeros(0),
        "connectivity": vtk_to_numpy(cells.GetConnectivityArray()),
        "stress components": tensors
        and [tensors.GetComponentName(i) for i in range(tensors.GetNumberOfComponents())],
    }


def as_in_file(block):
    """The points of meshio's cells in VTK's order: meshio turns wedges over."""
    return block.data[:, [0, 2, 1, 3, 5, 4]] if block.type == "wedge" else block.data


def check_meshio(checks, path, grid):
    """Everything meshio reads must be what VTK reads."""
    mesh = meshio.read(path)
    checks.close("meshio: points, against VTK", mesh.points, grid["points"])
    cells = [as_in_file(block).ravel() for block in mesh.cells]
    connectivity = np.concatenate(cells) if cells else np.zeros(0)
    checks.close("meshio: connectivity, against VTK", connectivity, grid["connectivity"])
    checks.same(f"{path}: point arrays", sorted(mesh.point_data), sorted(grid["point"]))
    for name, values in mesh.point_data.items():
        checks.close(f"meshio: {name}, against VTK", values, grid["point"][name])
    checks.same(f"{path}: cell arrays", sorted(mesh.cell_data), sorted(grid["cell"]))
    for name, blocks in mesh.cell_data.items():
        if blocks:
            values = np.concatenate(blocks)
            checks.close(f"meshio: {name}, against VTK", values, grid["cell"][name])


def single(values):
    return np.asarray(values).astype(np.float32)


def shells_or_solids(d3plot):
    """Kind of element that a d3plot holds, and which of its elements are no joints."""
    for kind, corners in [("shell", 3), ("solid", 4)]:
        nodes = d3plot.arrays.get(f"element_{kind}_node_indexes", np.zeros((0, 8)))
        if len(nodes):
            return kind, corners, (nodes[:, corners:] == nodes[:, [corners - 1]]).all(axis=1)
    return None, 0, None


def check_d3plot(checks, d3plot, outputs, states):
    """What lasso reads against the states and the collection."""
    arrays = d3plot.arrays
    times = arrays["timesteps"]
    checks.same("d3plot: number of states", len(times), len(outputs))
    expected = single([time for (time, _), _ in outputs])
    checks.close("lasso: times, against the collection", times, expected)
    checks.close("lasso: accelerations, against 0", arrays["node_acceleration"], 0.0 * arrays["node_velocity"])
    for index, ((_, step), _) in enumerate(outputs[: len(times)]):
        if step in states:
            state = states[step]
            # lasso calls the current coordinates displacement
            found = arrays["node_displacement"][index]
            checks.close("lasso: coordinates, against states", found, single(state.coordinates))
            found = arrays["node_velocity"][index]
            checks.close("lasso: velocities, against states", found, single(state.velocities))


def check_nodes(checks, grid, step, states):
    """Points of a grid of bodies against the states."""
    points = grid["point"]
    if step in states:
        state = states[step]
        checks.close("VTK: coordinates, against states", grid["points"], state.coordinates)
        checks.close("VTK: velocities, against states", points["velocity"], state.velocities)
    if step + 1 in states:
        state = states[step + 1]
        checks.close("VTK: forces, against states", points["force"], state.forces)
        checks.close("VTK: masses, against states", points["mass"], state.masses)
        checks.close("VTK: boundary flags, against states", points["boundary flag"], state.flags)
        checks.close("VTK: node sets, against states", points["boundary condition ID"], state.sets)
        corners = CORNERS[int(grid["types"][0])]
        expected = state.elements[grid["cell"]["element ID"], :corners]
        found = grid["connectivity"].reshape(-1, corners)
        checks.close("VTK: connectivity, against states", found, expected)


def check_joints(checks, grid, step, states):
    """A grid of joints against the states: each is a line along its middle."""
    if step in states:
        state = states[step]
        nodes = state.elements[grid["cell"]["element ID"], :4]
        x = state.coordinates[nodes]
        middle = np.stack([(x[:, 0] + x[:, 3]) / 2, (x[:, 1] + x[:, 2]) / 2], axis=1)
        found = grid["points"][grid["connectivity"].reshape(-1, 2)]
        checks.close("VTK: middles of joints, against states", found, middle)


def check_against_d3plot(checks, path, grid, index, d3plot):
    """A grid of bodies or of joints against what lasso reads."""
    kind, corners, is_continuum = shells_or_solids(d3plot)
    if kind is None:
        checks.fail("lasso finds no elements in the d3plot")
        return
    alive = d3plot.arrays[f"element_{kind}_is_alive"][index]
    energy = d3plot.arrays["global_kinetic_energy"][index]
    found = single(grid["field"]["kinetic energy"])
    checks.close("VTK: kinetic energy, against lasso", found, [energy])
    stresses = d3plot.arrays.get(f"element_{kind}_stress")
    if stresses is None:
        checks.fail("lasso finds no stresses in the d3plot")
        return
    # one integration point
    stresses = stresses[index].reshape(len(is_continuum), 6)
    if grid["types"][0] == VTK_LINE:
        of_joints = stresses[~is_continuum]
        checks.close("lasso: stresses of joints, against 0", of_joints, 0.0 * of_joints)
        broken = grid["cell"]["joint state"] == BROKEN
        checks.close("VTK: broken joints, against lasso", broken, alive[~is_continuum] == 0)
        return
    nodes = d3plot.arrays[f"element_{kind}_node_indexes"][is_continuum][:, :corners]
    checks.close("VTK: connectivity, against lasso", grid["connectivity"].reshape(-1, corners), nodes)
    material = d3plot.arrays[f"element_{kind}_part_indexes"][is_continuum]
    checks.close("VTK: materials, against lasso", grid["cell"]["material property ID"], material)
    names = grid["stress components"]
    checks.same(f"{path}: stress components", names, ["XX", "YY", "ZZ", "XY", "YZ", "XZ"])
    expected = single(grid["cell"][STRESS])
    if kind == "shell":
        expected = np.where(np.isin(np.arange(6), PLANE), expected, 0)
    checks.close("lasso: stresses, against VTK", stresses[is_continuum], expected)


def check_grids(checks, outputs, states, d3plot):
    """What VTK and meshio read against the states and the d3plot."""
    for index, ((time, step), parts) in enumerate(outputs):
        for part, path in sorted(parts.items()):
            grid = read_with_vtk(path)
            checks.close("VTK: TimeValue, against the collection", grid["field"]["TimeValue"], [time])
            if not len(grid["types"]):  # meshio 5.3.5 cannot read grids without cells
                continue
            check_meshio(checks, path, grid)
            if part == 0:
                check_nodes(checks, grid, step, states)
            else:
                check_joints(checks, grid, step, states)
            if d3plot is not None:
                check_against_d3plot(checks, path, grid, index, d3plot)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("run", type=Path, metavar="RUN_DIR", help="folder of the run")
    parser.add_argument("base", help="name of the results: that of the deck up to its last dot")
    parser.add_argument("--tolerance", type=float, default=0.0, help="allowed difference relative to the largest value (default: none)")
    options = parser.parse_args()

    outputs = read_collection(options.run / f"{options.base}.pvd")
    found = options.run.glob(f"{options.base}.state_*.txt")
    states = {int(path.stem.rpartition("_")[2]): read_state(path) for path in found}
    d3plot = D3plot(str(options.run / options.base))

    checks = Checks(options.tolerance)
    steps = {step for (_, step), _ in outputs}
    print(f"{len(outputs)} outputs, full-precision states of steps {sorted(states)}")
    if not steps & states.keys():
        checks.fail("no state file belongs to the coordinates of an output")
    if not {step + 1 for step in steps} & states.keys():
        checks.fail("no state file belongs to the forces of an output")
    check_d3plot(checks, d3plot, outputs, states)
    check_grids(checks, outputs, states, d3plot)
    sys.exit(checks.report())


if __name__ == "__main__":
    main()
