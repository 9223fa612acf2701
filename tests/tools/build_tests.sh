# Sourced by tests/run and tests/second_opengl.

# build_tests ROOT [TARGET...]: in ROOT/build/tests, everything without a target.
build_tests() {
  local root=$1
  shift
  # No NDEBUG: assert() stays on in an optimised build.
  cmake -G Ninja -S "$root" -B "$root/build/tests" -DLUXGATE_WERROR=ON \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O2"
  cmake --build "$root/build/tests" ${1:+--target "$@"}
}
