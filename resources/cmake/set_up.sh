# Sourced by app/run and tests/run: what Debian 12 needs installed, and how a preset is configured and built.
# shellcheck shell=bash

HAIRPAINT_PACKAGES=(
    ca-certificates git g++ cmake ninja-build ccache pkg-config
    qt6-base-dev qt6-base-dev-tools qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-svg-dev libqt6opengl6-dev
    libgl-dev libegl-dev libgl1-mesa-dri libegl1 libepoxy-dev libxkbcommon-dev
    libglm-dev libeigen3-dev libhwy-dev libtbb-dev libnanoflann-dev libexpected-dev libzip-dev zlib1g-dev libdeflate-dev
    libopenexr-dev libopenimageio-dev openimageio-tools libassimp-dev nlohmann-json3-dev
    qt6-translations-l10n fonts-inter fonts-noto-core
)
HAIRPAINT_TEST_PACKAGES=(xvfb xauth lld)
HAIRPAINT_BENCH_PACKAGES=(libbenchmark-dev libmypaint-dev)
HAIRPAINT_EXCHANGE_PACKAGES=(blender python3-numpy imagemagick chromium godot3-server)
HAIRPAINT_MODELS_PACKAGES=(assimp-testmodels)
HAIRPAINT_FUZZ_PACKAGES=(clang libclang-rt-14-dev)
HAIRPAINT_TIDY_PACKAGES=(clang-tidy clang-format libbenchmark-dev libmypaint-dev)

say() { printf '%s\n' "$*" >&2; }

# install PACKAGE...: installs those that are missing, as root or through sudo; says which, and does nothing when all are there.
install_packages() {
    local missing=() package as_root=()
    for package in "$@"; do
        dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' || missing+=("$package")
    done
    [ "${#missing[@]}" -eq 0 ] && return 0
    if ! command -v apt-get >/dev/null; then
        say "These Debian packages are needed, or their like on this system: ${missing[*]}"
        return 1
    fi
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || { say "Run as root or install sudo, to install: ${missing[*]}"; return 1; }
        as_root=(sudo)
    fi
    say "Installing ${#missing[@]} packages ..."
    if ! { "${as_root[@]}" apt-get update -qq &&
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"; } \
        >"${TMPDIR:-/tmp}/hairpaint-packages.log" 2>&1; then
        tail -n 5 "${TMPDIR:-/tmp}/hairpaint-packages.log" >&2
        say "The packages could not be installed; the whole log is ${TMPDIR:-/tmp}/hairpaint-packages.log"
        return 1
    fi
}

# configure PRESET [ARG...]: only where it was not yet.
configure() {
    local preset=$1
    shift
    [ -f "build/$preset/build.ninja" ] && [ "$#" -eq 0 ] && return 0
    mkdir -p "build/$preset"
    if ! cmake --preset "$preset" "$@" >"build/$preset/configure.log" 2>&1; then
        tail -n 20 "build/$preset/configure.log" >&2
        return 1
    fi
}

# build PRESET [TARGET...]
build() {
    local preset=$1
    shift
    configure "$preset" || return 1
    if ! cmake --build "build/$preset" ${1:+--target "$@"} >"build/$preset/build.log" 2>&1; then
        grep -E -A 6 'error:|FAILED:|undefined reference' "build/$preset/build.log" | head -n 40 >&2
        say "The build failed; the whole log is build/$preset/build.log"
        return 1
    fi
}
