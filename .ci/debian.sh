# SPDX-License-Identifier: GPL-3.0-or-later
# A Debian of its own in a folder, the smallest there is, made by debootstrap from where this machine's
# apt takes its packages; it needs root and the network. Sourced by .ci/on-debian and
# tests/packaging/bare_debian; ends them with status 77 where it cannot be made here.

skip() {
    echo "skipped: $1"
    exit 77
}
part() { echo "== $1 ($SECONDS s)"; }

# make_debian SUITE FOLDER: fills FOLDER, or takes what was made there before; sets root and work.
make_debian() {
    local suite=$1 own sources mirror
    [ "$(id -u)" = 0 ] || skip "only root can make a Debian"
    command -v debootstrap >/dev/null || skip "debootstrap is not installed"
    own=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
    # "URI RELEASE COMPONENT" of the sources of packages that apt knows, as the suite's.
    sources=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
        grep -E " $own(-updates|-security)? main$" | sed "s/ $own/ $suite/" | sort -u || true)
    mirror=$(awk -v suite="$suite" '$2 == suite {print $1; exit}' <<<"$sources")
    [ -n "$mirror" ] || skip "apt has no source of a Debian"
    mkdir -p "$2"
    root=$(realpath "$2")
    trap leave_debian EXIT
    if [ ! -e "$root/usr/bin/apt-get" ]; then
        quietly debootstrap --variant=minbase "$suite" "$root" "$mirror"
    fi
    sed 's/^/deb /' <<<"$sources" >"$root/etc/apt/sources.list"
    apt-config dump | grep '^Acquire::\(http\|https\)' >"$root/etc/apt/apt.conf.d/90host" || true
    cp /etc/resolv.conf "$root/etc/resolv.conf"
    mount -t proc proc "$root/proc"
    mount --bind /dev "$root/dev"
    mount --bind /dev/pts "$root/dev/pts"
    run_as root id visitor >/dev/null 2>&1 || run_as root useradd --create-home visitor
    quietly run_as root apt-get update
}
leave_debian() {
    for mounted in dev/pts dev proc; do
        if mountpoint -q "$root/$mounted"; then umount "$root/$mounted"; fi
    done
    rm -rf --one-file-system "$work"
}
run_as() { # run_as USER command...: in the new Debian, in the user's home
    local user=$1
    shift
    chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
        DEBIAN_FRONTEND=noninteractive QT_QPA_PLATFORM=offscreen \
        ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} \
        su "$user" -s /bin/bash -c 'cd && "$@"' -- bash "$@"
}
quietly() { "$@" >"$work/log" 2>&1 || { tail -n 60 "$work/log"; exit 1; }; }
work=$(mktemp -d)
