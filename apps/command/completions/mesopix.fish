# Completion of mesopix for fish: the program itself tells what may follow.

# Files with one of the endings, or any, and the folders on the way to them.
function __mesopix_files
    set -l pattern '/$|\.('(string join '|' -- $argv[2..-1])')$'
    for path in (__fish_complete_path $argv[1] | string split -f 1 \t)
        if test (count $argv) -eq 1; or string match -qri -- $pattern $path
            echo $path
        end
    end
end

function __mesopix_complete
    set -l words (commandline -opc)
    set -l word (commandline -ct)
    set -l before (string match -r '^.*=' -- "$word"; or echo)
    for line in ($words[1] complete $words[2..-1] "$word" 2>/dev/null)
        switch $line
            case '@files*'
                printf '%s\n' $before(__mesopix_files (string replace -r '^.*=' '' -- "$word") (string split -n ' ' -- $line)[2..-1])
            case @folders
                printf '%s\n' $before(__fish_complete_directories (string replace -r '^.*=' '' -- "$word") '')
            case '*'
                echo $before$line
        end
    end
end

complete -c mesopix -f -a '(__mesopix_complete)'
