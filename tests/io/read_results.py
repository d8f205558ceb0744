#!/usr/bin/python3
"""Opens results files with h5py and xarray and checks what a reader relies on.

usage: read_results.py run.h5 fit.h5 sweep.h5

Debian packages: python3-h5py python3-xarray python3-h5netcdf python3-pandas.
"""

import sys

import h5py
import xarray

# Numbers in a unit that another column gives, so without a `units` of their own.
MIXED_UNITS = {"initial", "lower", "upper", "best", "stderr", "lower95", "upper95", "naive_lower95", "naive_upper95", "x",
               "bounds", "from", "to"}


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def groups_of(file):
    """Paths of all groups that belong to the file itself."""
    paths = ["/"]

    def walk(group, prefix):
        for name in group:
            if isinstance(group.get(name, getlink=True), h5py.HardLink) and isinstance(group[name], h5py.Group):
                paths.append(prefix + name)
                walk(group[name], prefix + name + "/")

    walk(file, "/")
    return paths


def check_dataset(dataset):
    """A scale on each axis; a unit on each number; filters that carry a checksum."""
    name = dataset.name
    if dataset.dtype.kind in "OS":
        assert len(text(dataset.attrs["sha256"])) == 64, name
    elif dataset.shape:
        assert dataset.fletcher32 and dataset.compression == "gzip", name
    if not h5py.h5ds.is_scale(dataset.id):
        for size, dimension in zip(dataset.shape, dataset.dims):
            assert len(dimension) == 1, f"{name}: an axis without a scale"
            assert dimension[0].shape == (size,), name
    if dataset.dtype.kind in "if" and name.rsplit("/", 1)[-1] not in MIXED_UNITS:
        assert text(dataset.attrs["units"]), name
    dataset[()]


def check_with_h5py(path, schema):
    with h5py.File(path, "r") as file:
        assert text(file.attrs["schema"]) == schema
        assert file.attrs["complete"] == 1
        for key in ("software", "version", "git_sha", "seed", "input_sha256"):
            assert key in file["provenance"].attrs, key
        datasets = []
        file.visititems(lambda _, item: datasets.append(item) if isinstance(item, h5py.Dataset) else None)
        assert datasets
        for dataset in datasets:
            check_dataset(dataset)


def check_with_xarray(path):
    """Every group opens and loads, and its dimensions have names."""
    with h5py.File(path, "r") as file:
        groups = groups_of(file)
    for group in groups:
        with xarray.open_dataset(path, engine="h5netcdf", group=group) as data:
            data.load()
            for dimension in data.dims:
                assert not dimension.startswith("phony"), f"{path}{group}: {dimension}"


def check_with_netcdf(path):
    """netCDF-C reads every variable; 4.9 crashes on arrays of fixed-length text."""
    try:
        import netCDF4
    except ImportError:
        return

    def read(group):
        for variable in group.variables.values():
            variable[...]
        for name, child in group.groups.items():
            if name != "runs":
                read(child)

    with netCDF4.Dataset(path) as file:
        read(file)


def open_group(path, group):
    return xarray.open_dataset(path, engine="h5netcdf", group=group)


def check_run(path, prefix=""):
    with h5py.File(path, "r") as file:
        root = file[prefix or "/"]
        assert list(root["h5md"].attrs["version"]) == [1, 1]
        particles = root["particles/trajectory"]
        frames, count, three = particles["position/value"].shape
        assert (three, particles["box"].attrs["dimension"]) == (3, 3)
        assert "unit" not in particles["position/value"].attrs
        assert particles["mass"].shape == particles["species"].shape == (count,)
        assert root["connectivity/triangles"].shape[1] == 3
        lines = root["connectivity/muscle_lines"]
        assert lines.shape[1] >= 3 and 0 <= lines[:].min() and lines[:].max() < count
        for cells in (root["connectivity/triangles"], lines):
            assert root[cells.attrs["particles_group"][0]] == particles
        assert root["observables/dV/value"].shape == (frames,)
        assert root["observables/dV/time"] == particles["velocity/time"] == particles["position/time"]
        assert text(root["parameters/scenario_toml"][()])

    for quantity, units in (("position", "m"), ("velocity", "m s-1"), ("force", "N")):
        with open_group(path, f"{prefix}/particles/trajectory/{quantity}") as data:
            assert data.value.dims == ("time", "particle", "xyz"), data.value.dims
            assert data.value.units == units
            assert data.time.units == "s" and data.step.dims == ("time",)
    with open_group(path, f"{prefix}/curves") as curves:
        assert curves.dV_model.dims == ("time",) and curves.dV_model.units == "ml"
        frame = curves.to_dataframe()
        assert frame.index.name == "time" and "dV_model" in frame.columns
    with open_group(path, f"{prefix}/observables/dV") as volume, open_group(path, f"{prefix}/curves") as curves:
        there = curves.dV_model.interp(time=volume.time)
        assert float(abs(volume.value - there).max()) < 1e-9 * float(abs(curves.dV_model).max())


def check_fit(path):
    check_run(path, "best_run")
    with open_group(path, "parameters") as data:
        table = data.drop_dims(["covariance_row", "covariance_column"]).to_dataframe()
        assert {"unit", "initial", "best", "stderr", "at_bound", "free"} <= set(table.columns)
        assert data.covariance.dims == ("covariance_row", "covariance_column")
    with open_group(path, "problem") as data:
        assert data.measured.dims == ("time",) and data.measured.units == data.sigma.units == "ml"
        assert data.bounds.dims == ("parameter", "bound")
    with open_group(path, "evaluations") as data:
        assert data.x.dims == ("evaluation", "parameter")
        assert data.objective.dims == data.status.dims == data.wall_s.dims == ("evaluation",)
    with open_group(path, "result") as data:
        assert data.dV_fit.units == data.residual.units == "ml"
        assert data.attrs["verdict"] and data.attrs["stop_reason"]


def check_sweep(path):
    with open_group(path, "table") as data:
        table = data.to_dataframe()
        assert table.index.name == "run" and {"scenario", "status", "error", "run_file"} <= set(table.columns)
        assert all(isinstance(status, str) for status in table.status)
        runs = len(table)
    with open_group(path, "curves") as data:
        assert data.dV.dims == ("run", "time") and data.dV.units == "ml" and data.dV.shape[0] == runs
    with h5py.File(path, "r") as file:
        for number, name in enumerate(table.run_file):
            key = f"{number:05d}"
            link = file["runs"].get(key, getlink=True) if key in file["runs"].keys() else None
            assert (link is not None) == bool(text(name)), key
            assert link is None or link.filename == text(name)


def main():
    run, fit, sweep = sys.argv[1:]
    for path, schema in ((run, "trunk.run"), (fit, "trunk.fit"), (sweep, "trunk.sweep")):
        check_with_h5py(path, schema)
        check_with_xarray(path)
        check_with_netcdf(path)
    check_run(run)
    check_fit(fit)
    check_sweep(sweep)
    print("h5py and xarray read all three files")


if __name__ == "__main__":
    main()
