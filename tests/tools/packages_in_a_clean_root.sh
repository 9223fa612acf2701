#!/usr/bin/env bash
# What people do with the packages of report/packages/build, in a Debian of this release that has nothing else: install, first verdict, remove.
#   packages_in_a_clean_root.sh PACKAGES WORK [WAY...]     WAYS: deb archive container embed python; all unless given
# deb: apt install ./luxgate_*.deb. archive: the tar.gz unpacked in a folder of another name. container: the steps of the second
# stage of the Containerfile, in a root with the settings of Debian slim; it is no run of a container. embed: luxgate-dev, and
# examples/embed built with it. python: python3-luxgate, and examples/python run with it. What people run runs as a user without rights or network, on a root that nobody can write.
# Prints a table: seconds from nothing to the first verdict, size of what came. Says "skipped:" where root, debootstrap or a mirror
# is missing. Ends with 1 at the first thing that is not as it should be. WORK/base is kept for the next run.
# shellcheck disable=SC2016  # what apt, dpkg and a shell inside shall expand
set -euo pipefail
umask 022

skip() { echo "skipped: $*"; exit 0; }
[[ $# -ge 2 ]] || { echo "usage: packages_in_a_clean_root.sh PACKAGES WORK [WAY...]" >&2; exit 2; }
[[ $EUID -eq 0 ]] || skip "only root can make a root folder of its own"
command -v debootstrap >/dev/null || skip "debootstrap is not installed"
unshare --net --mount true 2>/dev/null || skip "no namespaces for mounts and the network here"

packages=$(realpath -- "$1")
mkdir -p -- "$2"
work=$(realpath -- "$2")
shift 2
ways=("$@")
[[ ${#ways[@]} -gt 0 ]] || ways=(deb archive container embed python)
shopt -s nullglob
program=("$packages"/luxgate_*.deb) development=("$packages"/luxgate-dev_*.deb) module=("$packages"/python3-luxgate_*.deb)
archive=("$packages"/luxgate-*.tar.gz)
[[ ${#program[@]} == 1 && ${#development[@]} == 1 && ${#module[@]} == 1 && ${#archive[@]} == 1 ]] || {
  echo "$packages: not one package of each kind" >&2; exit 1; }

# shellcheck source=/dev/null
codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' "Codename: $codename" 'Component: main' 2>/dev/null | head -n 1)
[[ -n $mirror ]] || skip "apt knows no mirror of $codename"
if [[ ! -e $work/base.done ]]; then
  # apt's own way to the mirror, with the proxy that it may need.
  /usr/lib/apt/apt-helper download-file "${mirror%/}/dists/$codename/Release" "$work/Release" >/dev/null 2>&1 ||
    skip "$mirror cannot be reached"
  rm -rf -- "$work/base"
  debootstrap --variant=minbase "$codename" "$work/base" "$mirror" >"$work/debootstrap.log" 2>&1 || {
    tail "$work/debootstrap.log"; exit 1; }
  touch "$work/base.done"
fi

fail() { echo "$way: $*" >&2; exit 1; }
seconds() { date +%s.%N; }
since() { awk -v from="$1" -v to="$(seconds)" 'BEGIN { printf "%.1f", to - from }'; }
mebibytes() { awk -v bytes="$1" 'BEGIN { printf "%.1f", bytes / 1048576 }'; }

fresh_root() {
  root="$work/$way"
  rm -rf -- "$root"
  cp -a -- "$work/base" "$root"
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  [[ ! -e /etc/apt/apt.conf ]] || cp /etc/apt/apt.conf "$root/etc/apt/apt.conf"
  mkdir "$root/work" "$root/packages"
  cp "${program[0]}" "${development[0]}" "${module[0]}" "$root/packages"
}

# Everything in the root but what dpkg and apt keep for themselves.
all_files() {
  (cd "$root" && find . -path ./var/lib/dpkg -prune -o -path ./var/lib/apt -prune -o -path ./var/cache -prune -o \
    -path ./var/log -prune -o -path ./packages -prune -o -path ./work -prune -o -path ./tmp -prune -o -print | sort)
}

as_root() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive "$@"; }

# run_in LINE: a line of sh, run in /work of the root. No network, nothing to write but /work.
run_in() {
  ROOT=$root LINE=$1 unshare --net --mount bash -euc '
    mount --make-rprivate /
    mount --bind "$ROOT" "$ROOT"
    mount -o remount,bind,ro "$ROOT"
    mount --bind "$ROOT/work" "$ROOT/work"
    mount -o remount,bind,rw "$ROOT/work"
    mount -t proc proc "$ROOT/proc"
    exec chroot --userspec=10001:10001 "$ROOT" env -i PATH=/usr/bin:/bin sh -c "cd /work; $LINE"'
}

expect() {  # EXIT_CODE LINE
  local status=0
  run_in "$2" >"$work/output" 2>&1 || status=$?
  [[ $status == "$1" ]] || { cat "$work/output"; fail "$2: exit code $status, expected $1"; }
}

# The first verdict, and that it could have been another one.
first_verdict() {  # PROGRAM
  chown 10001:10001 "$root/work"
  expect 0 "$1 init room && $1 check room/*.xml"
  grep -q "pass" "$work/output" || fail "no verdict in the output: $(cat "$work/output")"
}
other_verdicts() {  # PROGRAM
  expect 0 "$1 --version"
  expect 0 "! touch /here 2>/dev/null && ! touch /tmp/here 2>/dev/null && test \$(id -u) = 10001"
  expect 0 "test \$(grep -c : /proc/net/dev) = 1"
  expect 0 "sed s/at-least=.500./at-least=\\\"50000\\\"/ room/project.xml >room/dark.xml && ! cmp -s room/dark.xml room/project.xml"
  expect 1 "$1 check room/dark.xml"
  expect 2 "$1 check nothing.xml"
  expect 0 "$1 check room/project.xml --output out --images && test -s out/report.html && test -s out/result.json"
  expect 0 "$1 check room/project.xml --format json >result.json && $1 report result.json --format html >again.html && test -s again.html"
  expect 0 "$1 rules list && $1 schema >schema.xsd && test -s schema.xsd"
  expect 2 "$1 check room/project.xml --format pdf=report.pdf"
  grep -qi "chromium" "$work/output" || fail "nothing is said of Chromium: $(cat "$work/output")"
}

row() {  # SECONDS BYTES WHAT
  table+="$(printf '%-10s %8s s %9s MiB  %s' "$way" "$1" "$(mebibytes "$2")" "$3")"$'\n'
}
used() {
  (cd "$root" && du -s --block-size=1 --exclude=./packages --exclude=./work --exclude=./var/lib/apt --exclude=./var/cache . | cut -f 1)
}

# install NAME...: packages by apt, files of ours by /packages/FILE; packages.new: what came. Keeps what purge_all compares with.
install() {
  files=$(all_files)
  as_root apt-get update -qq >"$work/apt.log" 2>&1 || { cat "$work/apt.log"; fail "apt-get update"; }
  as_root dpkg-query -W -f '${Package}\n' | sort >"$work/packages.before"
  as_root apt-get install -y -qq --no-install-recommends "$@" >"$work/apt.log" 2>&1 || {
    cat "$work/apt.log"; fail "apt-get install"; }
  as_root dpkg-query -W -f '${Package}\n' | sort | comm -13 "$work/packages.before" - >"$work/packages.new"
}

# purge_all PACKAGE NAME...: files are those of the package; once it and all it brought have gone, nothing is left.
purge_all() {
  local package left
  as_root dpkg --verify "$1" >"$work/output" 2>&1 || true
  [[ ! -s $work/output ]] || fail "files differ from those of $1: $(cat "$work/output")"
  # apt keeps what came by itself and some other package suggests.
  as_root apt-get purge -y -qq --autoremove -o APT::AutoRemove::RecommendsImportant=false -o APT::AutoRemove::SuggestsImportant=false "$@" \
    >"$work/apt.log" 2>&1 || { cat "$work/apt.log"; fail "apt-get purge"; }
  for package in "$@" $(cat "$work/packages.new"); do
    # dpkg may remember the name alone, of what another package breaks.
    [[ $(as_root dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) =~ ^(not-installed)?$ ]] || fail "$package is still there after purge"
  done
  left=$(comm -13 <(echo "$files") <(all_files) | grep -v -e '^./etc/ld.so.cache$' || true)
  [[ -z $left ]] || fail "left after purge: $left"
}

try_deb() {
  fresh_root
  local before start took
  before=$(used) start=$(seconds)
  install "/packages/$(basename "${program[0]}")"
  first_verdict luxgate
  took=$(since "$start")
  row "$took" "$(($(used) - before))" "apt install; $(wc -l <"$work/packages.new") packages: $(tr '\n' ' ' <"$work/packages.new")"
  ! grep -e python -e '-dev$' "$work/packages.new" || fail "the program brings what it does not need"
  other_verdicts luxgate
  purge_all luxgate

  # The same by dpkg alone: it says what is missing and installs nothing that works by half.
  ! as_root dpkg -i "/packages/$(basename "${program[0]}")" >"$work/apt.log" 2>&1 || fail "dpkg -i without the libraries worked"
  grep -q "dependency problems" "$work/apt.log" || fail "dpkg says: $(cat "$work/apt.log")"
  as_root dpkg -P luxgate >"$work/apt.log" 2>&1 || { cat "$work/apt.log"; fail "dpkg -P"; }
}

try_archive() {
  fresh_root
  rm -rf "$root/packages"
  local start took library
  mkdir -p "$root/srv/other place"
  start=$(seconds)
  tar --extract --gzip --file "${archive[0]}" --directory "$root/srv/other place" --strip-components 1
  first_verdict "/srv/other\\ place/bin/luxgate"
  took=$(since "$start")
  row "$took" "$(du -s --block-size=1 "$root/srv" | cut -f 1)" "tar.gz of $(mebibytes "$(stat -c %s "${archive[0]}")") MiB, unpacked"
  other_verdicts "/srv/other\\ place/bin/luxgate"
  # By a link, and by a relative name; every library is its own or the system's C and C++.
  ln -s "../../srv/other place/bin/luxgate" "$root/usr/bin/luxgate"
  expect 0 "luxgate check room/project.xml"
  expect 0 "cd '/srv/other place/bin' && ./luxgate check /work/room/project.xml"
  expect 0 "LD_TRACE_LOADED_OBJECTS=1 luxgate"
  library=$(grep -v -e '=> /srv/other place/' -e 'linux-vdso' -e 'ld-linux' -e '/libc\.so' -e '/libm\.so' -e '/libdl\.so' \
    -e '/librt\.so' -e '/libresolv\.so' -e '/libpthread\.so' -e '/libstdc++\.so' -e '/libgcc_s\.so' "$work/output" || true)
  [[ -z $library ]] || fail "libraries from elsewhere: $library"
}

try_container() {
  fresh_root
  # What Debian's slim images leave out, as their dpkg has it.
  printf 'path-exclude /usr/share/%s/*\n' doc groff info linda lintian locale man >"$root/etc/dpkg/dpkg.cfg.d/slim"
  echo 'path-include /usr/share/doc/*/copyright' >>"$root/etc/dpkg/dpkg.cfg.d/slim"
  local before start took
  before=$(used) start=$(seconds)
  as_root sh -euc 'apt-get update && apt-get install -y --no-install-recommends /packages/luxgate_*.deb &&
    rm -rf /var/lib/apt/lists/* /var/cache/apt/* /var/log/* &&
    useradd --uid 10001 --no-create-home --home-dir /work --shell /usr/sbin/nologin luxgate' >"$work/apt.log" 2>&1 || {
      cat "$work/apt.log"; fail "the second stage"; }
  first_verdict luxgate
  took=$(since "$start")
  row "$took" "$(($(used) - before))" "second stage of the Containerfile, without the image of Debian"
  other_verdicts luxgate
}

try_embed() {
  fresh_root
  local before start
  before=$(used) start=$(seconds)
  install cmake make g++ "/packages/$(basename "${development[0]}")"
  cp -r "$(dirname -- "${BASH_SOURCE[0]}")/../../examples/embed" "$(dirname -- "${BASH_SOURCE[0]}")/../../examples/04-office" "$root/work"
  chown -R 10001:10001 "$root/work"
  expect 0 "export TMPDIR=/work; cmake -S embed -B build && cmake --build build && ./build/embed 04-office/project.xml"
  grep -q "average: pass" "$work/output" || fail "no verdict: $(cat "$work/output")"
  row "$(since "$start")" "$(($(used) - before))" "luxgate-dev with compiler and libraries, $(wc -l <"$work/packages.new") packages; examples/embed built and run"
  purge_all luxgate-dev cmake make g++
}

try_python() {
  fresh_root
  local before start took check="python3 /usr/share/doc/python3-luxgate/examples/check.py"
  before=$(used) start=$(seconds)
  install "/packages/$(basename "${module[0]}")"
  cp -r "$(dirname -- "${BASH_SOURCE[0]}")/../../examples/04-office" "$root/work"
  chown -R 10001:10001 "$root/work"
  expect 0 "$check 04-office/project.xml"
  grep -q "project.xml: pass" "$work/output" || fail "no verdict: $(cat "$work/output")"
  took=$(since "$start")
  row "$took" "$(($(used) - before))" "python3-luxgate with Python and numpy, $(wc -l <"$work/packages.new") packages; examples/python run"
  ! grep -x luxgate "$work/packages.new" || fail "the module brings the program"
  expect 1 "$check 04-office/project.xml >bright && sed 's/at-least=\"[0-9]*\"/at-least=\"50000\"/' 04-office/project.xml >04-office/dark.xml; $check 04-office/dark.xml"
  grep -q "dark.xml: fail" "$work/output" || fail "no other verdict: $(cat "$work/output")"
  # By root, where Python could write bytecode: what the package made is taken, and goes with it.
  as_root python3 -c 'import luxgate; print(luxgate.version)' >"$work/output" 2>&1 || fail "as root: $(cat "$work/output")"
  purge_all python3-luxgate
}

table=""
for way in "${ways[@]}"; do
  case $way in
    deb | archive | container | embed | python) "try_$way" ;;
    *) echo "$way: deb, archive, container, embed or python is needed" >&2; exit 2 ;;
  esac
  rm -rf -- "${work:?}/$way"
done
printf '%s' "$table"
