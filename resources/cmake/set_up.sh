# Sourced by app/run and tests/run: what Debian 12 needs installed, and how a preset is configured and built.
# shellcheck shell=bash

HAIRPAINT_PACKAGES=(
    ca-certificates git g++ cmake ninja-build ccache lld pkg-config
    qt6-base-dev qt6-base-dev-tools qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-svg-dev libqt6opengl6-dev
    libgl-dev libegl-dev libgl1-mesa-dri libegl1 libepoxy-dev libxkbcommon-dev
    libglm-dev libeigen3-dev libhwy-dev libtbb-dev libnanoflann-dev libexpected-dev libzip-dev zlib1g-dev libdeflate-dev
    libopenexr-dev libopenimageio-dev openimageio-tools libassimp-dev nlohmann-json3-dev libseccomp-dev
    liblcms2-dev libwebp-dev libjpeg-dev
    libtinygltf-dev libmeshoptimizer-dev libdraco-dev
    qt6-translations-l10n fonts-inter fonts-noto-core
)
HAIRPAINT_TEST_PACKAGES=(xvfb xauth desktop-file-utils appstream shared-mime-info xdg-utils libfile-mimeinfo-perl man-db)
HAIRPAINT_BENCH_PACKAGES=(libbenchmark-dev libmypaint-dev)
HAIRPAINT_EXCHANGE_PACKAGES=(blender python3-numpy imagemagick chromium godot3-server)
HAIRPAINT_PACKAGE_PACKAGES=(lintian debootstrap patchelf xvfb imagemagick)
HAIRPAINT_MODELS_PACKAGES=(assimp-testmodels)
HAIRPAINT_CLANG_PACKAGES=(clang libclang-rt-14-dev)
HAIRPAINT_TIDY_PACKAGES=(clang-tidy clang-format libbenchmark-dev libmypaint-dev)

say() { printf '%s\n' "$*" >&2; }

# show_progress WHAT: reads lines "DONE/ALL ..." and says "WHAT DONE of ALL" when they end and every few seconds until
# then, also where nothing comes: nobody is to wonder whether it still works.
show_progress() {
    local what=$1 line state="" said="" start=$SECONDS last=$SECONDS
    while true; do
        if IFS= read -r -t 2 line; then
            state=${line%%[[:space:]]*}
        elif [ $? -le 128 ]; then
            break
        fi
        if [ $((SECONDS - last)) -ge 8 ]; then
            said=$state
            last=$SECONDS
            say "   $what ${state:+${state%/*} of ${state#*/}, }$((SECONDS - start)) s"
        fi
    done
    [ "$state" = "$said" ] || say "   $what ${state%/*} of ${state#*/}, $((SECONDS - start)) s"
}

# install_packages PACKAGE...: installs those that are missing, as root or through sudo; does nothing when all are there.
install_packages() {
    local missing=() package as_root=() log=${TMPDIR:-/tmp}/hairpaint-packages.log
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
    say "Installing: ${missing[*]}"
    # Packages that come along count, too: apt tells first how many are new, then of each that it unpacks and sets it up.
    { "${as_root[@]}" apt-get update -qq &&
        "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get install -y --no-install-recommends "${missing[@]}"; } \
        2>&1 | tee "$log" | count_packages | show_progress "installing"
    if [ "${PIPESTATUS[0]}" -ne 0 ]; then
        tail -n 5 "$log" >&2
        say "The packages could not be installed; the whole log is $log"
        return 1
    fi
}

# count_packages: apt-get's output as lines "DONE/ALL", two steps a package.
count_packages() {
    local line all=0 done=0
    while IFS= read -r line; do
        case "$line" in
        *" newly installed, "*) all=${line%% newly installed*} all=$((${all##* } * 2)) ;;
        "Unpacking "* | "Setting up "*) done=$((done + 1)) ;;
        *) continue ;;
        esac
        echo "$done/$((all > done ? all : done))"
    done
}

# configure PRESET [ARG...]: only where it was not yet, or the presets have changed since.
configure() {
    local preset=$1
    shift
    [ "build/$preset/build.ninja" -nt CMakePresets.json ] && [ "$#" -eq 0 ] && return 0
    mkdir -p "build/$preset"
    say "   configuring $preset"
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
    NINJA_STATUS='%f/%t ' cmake --build "build/$preset" ${1:+--target "$@"} 2>&1 | tee "build/$preset/build.log" |
        grep --line-buffered -E '^[0-9]+/[0-9]+ ' | show_progress "building $preset"
    if [ "${PIPESTATUS[0]}" -ne 0 ]; then
        grep -E -A 6 'error:|FAILED:|undefined reference' "build/$preset/build.log" | head -n 40 >&2
        say "The build failed; the whole log is build/$preset/build.log"
        return 1
    fi
}
