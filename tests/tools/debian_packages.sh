# Sourced by whatever builds luxgate: installs the Debian packages named, if any is missing. Quick when nothing is missing
# (one dpkg query). Needs root or sudo only to install. On a system whose package names nobody has tried, it says what is
# needed and leaves the rest to what is installed.

# "debian 12", "ubuntu 24.04"; "" where the file is missing.
luxgate_release=$([[ ! -r /etc/os-release ]] || (. /etc/os-release && echo "${ID:-} ${VERSION_ID:-}"))

luxgate_build_packages=(
  cmake ninja-build g++
  libembree-dev libcli11-dev libpugixml-dev libfmt-dev libopenexr-dev libglm-dev libtbb-dev libhwy-dev libsleef-dev
  nlohmann-json3-dev libpng-dev libtinyobjloader-dev libtinygltf-dev libssl-dev libzip-dev libegl-dev
  libepoxy-dev libgit2-dev libcpp-httplib-dev libqpdf-dev libtomlplusplus-dev zlib1g-dev
  coinor-libclp-dev coinor-libcbc-dev
)
luxgate_python_packages=(pybind11-dev python3-dev python3-numpy)  # the Python module
luxgate_test_packages=(
  "${luxgate_python_packages[@]}"
  libgtest-dev libgmock-dev libxml2-utils python3-jsonschema
  git python3-yaml  # revisions, and the jobs in examples/ci
  libegl1 libopengl0 libegl-mesa0 libgl1-mesa-dri  # OpenGL in software, for --backend gpu
)
luxgate_packaging_packages=(dpkg-dev file)  # of report/packages/build only
luxgate_second_opengl_packages=(mesa-vulkan-drivers)  # of tests/second_opengl only
luxgate_fuzz_packages=(clang libclang-rt-dev)  # of tests/fuzz/run only
# What a release calls otherwise.
case $luxgate_release in
  "debian 12") luxgate_fuzz_packages=(clang libclang-rt-14-dev) ;;
  "ubuntu 24.04") luxgate_fuzz_packages=(clang libclang-rt-18-dev) ;;
esac

# install_debian_packages NAME...
install_debian_packages() {
  local missing=() name
  case $luxgate_release in
    "debian 12" | "debian 13" | "ubuntu 24.04") ;;
    *)
      echo "This system is '$luxgate_release'; the names of its packages are known on Debian 12, Debian 13 and Ubuntu 24.04." >&2
      echo "Nothing is installed, the build goes on with what is there. On Debian these packages are needed: $*" >&2
      return 0
      ;;
  esac
  for name in "$@"; do
    [[ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" == installed ]] ||
      missing+=("$name")
  done
  [[ ${#missing[@]} -eq 0 ]] && return 0

  local as_root=()
  if [[ $EUID -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
      echo "Missing Debian packages, and neither root nor sudo to install them: ${missing[*]}" >&2
      return 2
    fi
    as_root=(sudo)
  fi
  echo "Installing Debian packages: ${missing[*]}" >&2
  # env: sudo drops variables set before it. Standard output is left to the program's results.
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}
