# Completes the commands of prehend, their options, and the robots and scenes that come with it.

# The words that the help of a command (or without one: of the program) names at the start of a line.
_prehend_words() {  # PROGRAM PATTERN [COMMAND...]
  "$1" "${@:3}" --help 2> /dev/null | grep -oE "$2"
}

_prehend_names() {  # PROGRAM FOLDER
  local program folder
  program=$(readlink -f "$(type -P "$1")") || return
  folder=${PREHEND_DATA:-$(dirname "$(dirname "$program")")/share/prehend}/$2
  [[ -d $folder ]] && find "$folder/" -mindepth 1 -maxdepth 1 -printf '%f\n' | sed 's/\.json$//'
}

_prehend() {
  local program=$1 word=$2 before=$3 words=
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    words=$(_prehend_words "$program" '^  [a-z]+')
  elif [[ $word == -* ]]; then
    words=$(_prehend_words "$program" '(^ *|,)--?[a-z][a-z-]*' "${COMP_WORDS[1]}" | tr -d ,)
  elif [[ $before == --hand ]]; then
    words=$(_prehend_names "$program" robots)
  elif [[ $before == plan || $before == simulate || $before == studio || $before == --scene ]]; then
    words=$(_prehend_names "$program" scenes)
  elif [[ ${COMP_WORDS[1]} == batch ]] && ((COMP_CWORD == 2)); then
    words=$(_prehend_words "$program" '^  [a-z]+' batch)
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}

# Where nothing fits, files.
complete -o default -F _prehend prehend
