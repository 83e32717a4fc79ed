# SPDX-License-Identifier: GPL-3.0-or-later
# What .ci/run and .ci/nightly have in common; sourced by both in the project's folder.

part() { # part NAME: ends the part before and begins this one
    [ -z "${name:-}" ] || echo "== $name: $((SECONDS - begin)) s"
    name=$1 begin=$SECONDS
    echo "== $name"
}
built() { # built PRESET [OPTION…]: configures and builds
    cmake --preset "$1" --log-level=WARNING
    cmake --build --preset "$@"
}
