# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# This file is sourced by scripts that try something in a Debian in which only what debootstrap calls minbase is
# installed. Needs root. dpkg does not wait until its files are on the disk. DEBIAN_MIRROR is where the packages come
# from; http://deb.debian.org/debian if it is not set.
#
#   use_debian 12|13    sets `project`, `folder`, where roots and logs are, and `suite`; makes the root that is copied
#   new_root NAME       sets `root`: a copy of it, in which there is nothing but Debian
#   copy_project PLACE  the sources, also those that git does not know yet, to a place in the root
#   inside USER COMMAND runs a command in the root, in the home of the user, whose name `home` is

use_debian() {
  case ${1:-} in
    12) suite=bookworm ;;
    13) suite=trixie ;;
    *) return 2 ;;
  esac
  if [ "$(id -u)" -ne 0 ]; then
    echo "$0: debootstrap needs root" >&2
    exit 2
  fi
  project=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
  folder="$project/build/bare_debian/$1"
  path=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
  home=/root
  mkdir -p "$folder"
  command -v debootstrap > /dev/null || apt-get install --quiet=2 --yes --no-install-recommends debootstrap
  if [ ! -e "$folder/base.complete" ]; then
    rm -rf --one-file-system "$folder/base"
    debootstrap --variant=minbase "$suite" "$folder/base" "${DEBIAN_MIRROR:-http://deb.debian.org/debian}" \
      > "$folder/debootstrap.log"
    echo force-unsafe-io > "$folder/base/etc/dpkg/dpkg.cfg.d/unsafe_io"
    rm -f "$folder"/base/var/cache/apt/archives/*.deb
    touch "$folder/base.complete"
  fi
}

new_root() { # NAME
  root="$folder/$1"
  rm -rf --one-file-system "$root"
  cp --archive --reflink=auto "$folder/base" "$root"
}

copy_project() { # PLACE
  mkdir -p "$root$1"
  (cd "$project" && git ls-files -z --cached --others --exclude-standard |
    tar --create --null --ignore-failed-read --files-from=-) | tar --extract --directory "$root$1"
}

# In namespaces of its own: mounts and processes end with it.
inside() { # USER COMMAND
  # shellcheck disable=SC2016
  unshare --mount --pid --fork sh -c '
    mount --rbind /dev "$1/dev" && mount -t proc proc "$1/proc" && mount -t sysfs sysfs "$1/sys" &&
      exec chroot --userspec="$2:$2" "$1" /usr/bin/env -i HOME="$3" LANG=C.UTF-8 PATH="$4" \
        http_proxy="${http_proxy:-}" bash -c "cd $3 && $5"' \
    sh "$root" "$1" "$home" "$path" "$2" < /dev/null
}

megabytes() {
  du --summarize --one-file-system --block-size=1M "$@" | tail -n 1 | cut -f 1
}
