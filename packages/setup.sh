# Sourced by demo and check: install_packages LIST... installs what packages/LIST.txt names and the machine lacks.
# Exits with 2, naming what is missing, where that cannot be done.
# shellcheck shell=bash

missing_packages() {
  local list name
  for list in "$@"; do
    while read -r name; do
      case $name in '' | '#'*) continue ;; esac
      [[ $(dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null) == installed ]] || echo "$name"
    done <"packages/$list.txt"
  done
}

install_packages() {
  local missing as_root=()
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]})) || return 0

  if ! command -v apt-get >/dev/null; then
    give_up "there is no apt-get here" "${missing[@]}"
  elif ((EUID != 0)); then
    command -v sudo >/dev/null || give_up "only root can install them, and there is no sudo" "${missing[@]}"
    as_root=(sudo)
    [[ -t 0 ]] || as_root+=(--non-interactive)
  fi
  echo "Installing ${missing[*]}"
  as_root+=(env DEBIAN_FRONTEND=noninteractive)
  { "${as_root[@]}" apt-get update --quiet
    "${as_root[@]}" apt-get install --quiet --yes --no-install-recommends "${missing[@]}"; } </dev/null || true
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]} == 0)) || give_up "apt-get did not install them" "${missing[@]}"
}

give_up() {
  local reason=$1
  shift
  echo "These packages are missing and could not be installed ($reason): $*" >&2
  exit 2
}
