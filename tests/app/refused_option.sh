#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# refused_option.sh PROGRAM OPTION WORDS: the program ends with 2 and says WORDS.
said=$("$1" "$2" 2>&1)
code=$?
printf '%s\n' "$said"
[ "$code" = 2 ] || { echo "exit code $code"; exit 1; }
case $said in *"$3"*) ;; *) exit 1 ;; esac
