# Installs what packages.txt lists and the machine lacks. Sourced by quickstart.sh and Testing/run.sh.

install_missing_packages()
{
  local list wanted missing=() package sudo=()
  list="$1"
  command -v dpkg-query >/dev/null || { echo "This is no Debian: install what $list names, then build with CMake." >&2; return 1; }
  mapfile -t wanted < <(sed 's/#.*//' "$list" | awk 'NF {print $1}')
  for package in "${wanted[@]}"; do
    command -v "$package" >/dev/null && continue # a program of that name, from wherever
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  echo "Installing Debian packages: ${missing[*]}"
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "Run this once as root, or install them yourself: apt-get install ${missing[*]}" >&2; return 1; }
    sudo=(sudo)
  fi
  "${sudo[@]}" apt-get update -qq
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}
