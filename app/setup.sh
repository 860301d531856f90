# shellcheck shell=bash
# Sourced by app/run, tests/run and .ci/run: installs what is missing, configures and builds.

# The folder of the project.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() {
    printf 'kriva: %s\n' "$*"
}

die() {
    printf 'kriva: %s\n' "$*" >&2
    exit 1
}

# as_root COMMAND...: runs it with the rights to install.
as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        die "installing needs root or sudo: $*"
    fi
}

# missing_packages LIST...: the packages named in the lists that dpkg does not know as installed, one a line.
missing_packages() {
    local name
    sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$@" | sort -u | while read -r name; do
        if [ "$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null)" != installed ]; then
            printf '%s\n' "$name"
        fi
    done
}

# install_missing LIST...: asks nothing, and does not call apt where nothing is missing.
install_missing() {
    if ! command -v dpkg-query >/dev/null; then
        say "this is not Debian; install by hand what $* name"
        return
    fi
    local missing
    mapfile -t missing < <(missing_packages "$@")
    if [ "${#missing[@]}" -eq 0 ]; then
        return
    fi
    say "installing ${missing[*]}"
    local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300)
    # A source of packages that is out of reach is no reason to stop: the install below tells what is really missing.
    as_root "${apt[@]}" update || say "not every package list could be refreshed"
    as_root "${apt[@]}" install -y --no-install-recommends "${missing[@]}"
}

# build PRESET [CMAKE-ARGUMENT...]: configures and builds everything of a preset.
build() {
    local preset=$1
    shift
    say "building $preset"
    (
        cd "$root" || exit
        cmake --preset "$preset" -Wno-dev "$@" >/dev/null
        cmake --build --preset "$preset" --parallel "$(nproc)"
    )
}
