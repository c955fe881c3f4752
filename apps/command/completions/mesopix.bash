# Completion of mesopix for bash: the program itself tells what may follow.

# Files with one of the endings, or any, and the folders on the way to them.
_mesopix_files() {
  local ending
  if [[ $# -eq 0 ]]; then
    compgen -f -- "$cur"
  else
    compgen -d -- "$cur"
    for ending; do
      compgen -f -X "!*.$ending" -- "$cur"
      compgen -f -X "!*.${ending^^}" -- "$cur"
    done
  fi
}

_mesopix() {
  local cur=${COMP_WORDS[COMP_CWORD]} words=() i line word endings
  for ((i = 1; i <= COMP_CWORD; i++)); do
    if ((i > 1)) && [[ ${COMP_WORDS[i]} == = || ${COMP_WORDS[i - 1]} == = ]]; then
      words[-1]+=${COMP_WORDS[i]}  # readline makes three words of key=value
    else
      words+=("${COMP_WORDS[i]}")
    fi
  done
  [[ $cur == = ]] && cur=
  COMPREPLY=()
  while IFS= read -r line; do
    word=${line%%$'\t'*}
    case $line in
      @files*)
        compopt -o filenames 2>/dev/null
        read -ra endings <<< "${line#@files}"
        mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(_mesopix_files "${endings[@]}")
        ;;
      @folders)
        compopt -o filenames 2>/dev/null
        mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$cur")
        ;;
      "$cur"*)
        [[ $word == *= ]] && compopt -o nospace 2>/dev/null
        COMPREPLY+=("$word")
        ;;
    esac
  done < <("${COMP_WORDS[0]/#\~/$HOME}" complete "${words[@]}" 2>/dev/null)
}

complete -F _mesopix mesopix
