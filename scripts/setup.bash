# Sourced by the scripts: Debian packages and the build. Runs as root or as a user with sudo.

# Builds and runs the program, and reads its files for the plots and tables of quickstart.
runtime_packages=(g++ cmake ninja-build pkg-config git
  libeigen3-dev libnlopt-dev libgsl-dev libhdf5-dev libsqlite3-dev libssl-dev
  libcli11-dev libfmt-dev nlohmann-json3-dev libtomlplusplus-dev libpugixml-dev libmatio-dev libedf-dev zlib1g-dev
  liblz4-dev liblzma-dev
  python3 python3-h5py python3-matplotlib python3-numpy)

# The tests also need other people's readers of the results (MDAnalysis and VTK take most of a minute), a browser with its
# own driver, which always has the same version, and a Slurm.
test_packages=(catch2 clang-format hdf5-tools python3-h5netcdf python3-mdanalysis python3-netcdf4 python3-pandas python3-vtk9
  python3-xarray chromium chromium-driver python3-selenium slurmctld slurmd slurm-client munge
  groff-base zsh fish)

# The nightly checks and scripts/lint need another compiler.
lint_packages=(clang clang-tidy)

say() { printf '\n== %s\n' "$*"; }

# Installs what is missing; asks for nothing and touches no network where all is there.
install_packages() {
  local missing=() package
  for package in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  say "Installing ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "these packages need root or sudo to install" >&2; return 1; }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# configure PRESET: prints what CMake says only where it fails.
configure() {
  local log
  log=$(cmake --preset "$1" -Wno-dev 2>&1) || { printf '%s\n' "$log"; return 1; }
}

# build_with PRESET: configures and builds in the folder the preset names.
build_with() {
  say "Building ($1)"
  configure "$1"
  cmake --build --preset "$1"
}
