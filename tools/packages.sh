# shellcheck shell=bash disable=SC2034
# What is installed, and how. Sourced by ../course, which sets no_install.

# What each command needs: Debian's package, and after a colon the program that stands in for it where there is one.
base_packages="g++:g++ make:make cmake:cmake libeigen3-dev doctest-dev"
scene_packages="nlohmann-json3-dev libcxxopts-dev" # scene files, simulate and advise
truth_packages="libboost-dev" # to hold the exact solutions against, and to compare with, in chapter 13
speed_packages="ninja-build:ninja ccache:ccache" # used when present, never required
book_packages="doxygen:doxygen doxygen-awesome-css libjs-katex nodejs:node gnuplot-nox:gnuplot
  python3:python3 fonts-lato fonts-jetbrains-mono fonts-dejavu-core python3-fonttools python3-brotli librsvg2-bin:rsvg-convert
  libbenchmark-dev"
live_packages="clang:clang++ lld:wasm-ld wasi-libc libc++-dev-wasm32 libclang-rt-dev-wasm32" # the book's figures that one can touch; still without
bits_packages="nodejs:node libc++-dev libc++abi-dev qemu-user:qemu-aarch64 g++-aarch64-linux-gnu:aarch64-linux-gnu-g++
  g++-riscv64-linux-gnu:riscv64-linux-gnu-g++ g++-s390x-linux-gnu:s390x-linux-gnu-g++ g++-i686-linux-gnu:i686-linux-gnu-g++"
# The tests read the book's pages, judge scene files and spell what is written with them.
test_packages="node-parse5 python3-jsonschema hunspell:hunspell hunspell-en-gb"
browser_packages="chromium:chromium"
npm_packages="npm:npm" # fetches what drives the browser in the slow tests
peer_packages="libbenchmark-dev libbullet-dev libode-dev libsimbody-dev" # bench measures, and measures with, these
all_packages="clang:clang++ libclang-rt-dev clang-format:clang-format clang-tidy:clang-tidy shellcheck:shellcheck
  valgrind:valgrind slurm-wlm:slurmctld munge:munged"

system_file=/etc/os-release

# missing ENTRY...: the packages among them of which there is neither the program nor the package.
missing() {
  local entry installed=" " absent=()
  for entry in "$@"; do
    case $entry in *:*) command -v "${entry#*:}" >/dev/null 2>&1 && continue ;; esac
    absent+=("${entry%%:*}")
  done
  [ "${#absent[@]}" -gt 0 ] || return 0
  if command -v dpkg-query >/dev/null 2>&1; then
    # shellcheck disable=SC2016  # the braces are dpkg-query's own
    installed=" $(dpkg-query -W -f '${db:Status-Status}:${Package} ' "${absent[@]}" 2>/dev/null) "
  fi
  for entry in "${absent[@]}"; do
    case $installed in *" installed:$entry "*) ;; *) printf '%s ' "$entry" ;; esac
  done
}

# without WORD LIST: the list, in which every word ends with a space, without the word.
without() {
  local list=" $2"
  list=${list/ $1 / }
  printf '%s' "${list# }"
}

# Whether this is a system whose packages are known; sets `system` to its name.
system_has_apt() {
  local ID="" VERSION_ID=""
  # shellcheck source=/dev/null
  [ -r "$system_file" ] && . "$system_file"
  system=$ID
  command -v apt-get >/dev/null 2>&1 || return 1
  case $ID in # Debian's testing and unstable have no number
    debian) [ "${VERSION_ID:-99}" -ge 12 ] ;;
    ubuntu) [ "${VERSION_ID%%.*}" -ge 24 ] ;;
    *) return 1 ;;
  esac
}

# ensure REQUIRED OPTIONAL: installs what is missing of both, or says what to do. Stops if required packages stay away.
ensure() {
  local required optional wanted system rights=""
  # shellcheck disable=SC2086  # lists of words
  {
    required=$(missing $1)
    optional=$(missing $2)
  }
  wanted=$required$optional
  [ -n "$wanted" ] || return 0
  if ! system_has_apt; then
    [ -z "$required" ] || printf '%s\n' "This is not Debian 12 or Ubuntu 24.04 or later, so nothing is installed here." \
      "If what follows fails, install by your system's means what Debian calls: $required"
    return 0
  fi
  if [ "$system" = ubuntu ] && [[ " $wanted" = *" chromium "* ]]; then
    echo "Ubuntu has Chromium as a snap only, which is not installed here; what needs a browser is left out."
    required=$(without chromium "$required")
    optional=$(without chromium "$optional")
    wanted=$required$optional
    [ -n "$wanted" ] || return 0
  fi
  if [ -n "$no_install" ]; then
    echo "Missing, and not installed because of --no-install: ${wanted% }"
    return 0
  fi
  if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo >/dev/null 2>&1 && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
      rights="sudo"
    elif [ -n "$required" ]; then
      die "these packages are missing, and only the administrator can install them: ${required% }" \
        "The one command for that:  sudo apt-get install --no-install-recommends ${required% }"
    else
      return 0
    fi
  fi
  echo "Installing ${wanted% }"
  [ -z "$rights" ] || sudo -v || die "sudo refused, so nothing was installed"
  # shellcheck disable=SC2086  # lists of words
  {
    stage "Fetched the lists of packages" $rights apt-get update ||
      echo "Trying with the lists that are here."
    stage "Installed what was missing" $rights env DEBIAN_FRONTEND=noninteractive \
      apt-get -o DPkg::Lock::Timeout=120 install -y --no-install-recommends $wanted || exit 1
  }
}
