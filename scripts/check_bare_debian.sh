#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs demo.sh and test.sh from nothing: in a Debian in which only what debootstrap calls minbase is installed. Prints
# for each run the exit code, the time, what it downloaded and what it takes on the disk, and ctest's summary. Needs
# root.
#
#   scripts/check_bare_debian.sh 12|13 [USER:COMMAND]...
#
#   USER      root
#             sudo      a user whom sudo allows apt-get and nothing else; one source of apt does not answer
#             nosudo    a user without sudo: the command must say what root is to install, and run when that is done
#   COMMAND   demo, test
#
# Without these arguments each user runs both commands. It takes hours, and 3 GB for each run in build/bare_debian,
# where the logs are, too. See scripts/bare_debian.sh for where the packages come from.
set -euo pipefail

usage() {
  sed --quiet 's/^#   scripts/usage: scripts/p' "$0" >&2
  exit 2
}

# shellcheck source=scripts/bare_debian.sh
. "$(dirname "${BASH_SOURCE[0]}")/bare_debian.sh"
case ${1:-} in 12 | 13) ;; *) usage ;; esac
release=$1
shift
[ $# -gt 0 ] || set -- {root,sudo,nosudo}:{demo,test}
for run in "$@"; do
  [[ $run =~ ^(root|sudo|nosudo):(demo|test)$ ]] || usage
done
use_debian "$release"

# What the command must show, whatever its exit code.
check_log() { # COMMAND LOG
  if grep -E 'command not found|CMake Warning \(dev\)' "$2"; then
    echo "  $2 must not have these lines"
    return 1
  fi
  if [ "$1" = demo ] && ! tail -n 1 "$2" | grep --quiet '^Open .*armadillo.html in a browser'; then
    echo "  $2 does not end with what to open"
    return 1
  fi
}

status=0
for run in "$@"; do
  user=${run%:*} command=${run#*:}
  new_root "$user-$command"
  log="$root.log"
  path=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
  if [ "$user" = root ]; then
    name=root home=/root
  else
    name=tester home=/home/tester
    chroot "$root" useradd --create-home --shell /bin/bash tester
  fi
  copy_project "$home/project"
  chown --recursive "$(stat --format=%u:%g "$root$home")" "$root$home/project"
  if [ "$user" = sudo ]; then
    { inside root "apt-get update && apt-get install --yes --no-install-recommends sudo"; } > "$folder/sudo.log" 2>&1
    echo "tester ALL=(root) NOPASSWD: /usr/bin/apt-get" > "$root/etc/sudoers.d/tester"
    echo "127.0.1.1 $(hostname)" >> "$root/etc/hosts"
    echo "deb http://127.0.0.1:9/debian none main" > "$root/etc/apt/sources.list.d/does_not_answer.list"
  fi
  if [ "$user" != root ]; then
    path=/usr/local/bin:/usr/bin:/bin
  fi

  before=$(megabytes "$root")
  seconds=$SECONDS
  code=0
  inside "$name" "cd project && ./scripts/$command.sh" > "$log" 2>&1 || code=$?
  if [ "$user" = nosudo ]; then
    # The last line is what root is to do.
    asked=$(tail -n 1 "$log" | sed --quiet 's/.*As root: //p')
    if [ "$code" -eq 0 ] || [ -z "$asked" ]; then
      echo "  $log does not say what is to be installed"
      status=1
    fi
    path=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
    inside root "export DEBIAN_FRONTEND=noninteractive; ${asked//install /install --yes }" > "$folder/nosudo.log" 2>&1
    path=/usr/local/bin:/usr/bin:/bin
    code=0
    inside "$name" "cd project && ./scripts/$command.sh" > "$log" 2>&1 || code=$?
  fi
  printf 'Debian %s, %s, %s.sh: exit code %s, %s minutes, %s MB of packages downloaded, %s MB on disk. %s\n' \
    "$release" "$user" "$command" "$code" $(((SECONDS - seconds + 30) / 60)) \
    "$(megabytes "$root/var/cache/apt/archives")" $(($(megabytes "$root") - before)) \
    "$(grep -E 'tests passed' "$log" | tail -n 1)"
  [ "$code" -eq 0 ] && check_log "$command" "$log" || status=1
done
exit "$status"
