#!/bin/sh
# A small box without a screen, such as a single-board computer at a test stand: records one hammer test after another,
# and says with its exit code and a log whether each is complete.
#   record_unattended.sh DEVICE FOLDER [TESTS] [OPTION]...
# DEVICE is a name that "percuss devices" lists; sim:aluminium-bat tries it. TESTS is a number; without it, there is one
# test. Options go to percuss record; the analysis has the same --band.
set -u
device=$1
folder=$2
shift 2
tests=1
case ${1:-} in
  '' | *[!0-9]*) ;;
  *) tests=$1 && shift ;;
esac
band=
previous=
for option in "$@"; do
  [ "$previous" = --band ] && band=$option
  case $option in --band=*) band=${option#--band=} ;; esac
  previous=$option
done

mkdir -p "$folder" || exit 3
worst=0
number=1
while [ "$number" -le "$tests" ]; do
  test="$folder/test-$number.h5"
  if [ -e "$test.journal" ]; then
    percuss record --resume "$test"  # the power failed during this test
  elif [ -e "$test" ]; then
    number=$((number + 1))
    continue
  else
    percuss record -o "$test" --device "$device" "$@"
  fi
  code=$?
  case $code in
    0) percuss analyze "$test" --json ${band:+--band "$band"} > "$folder/test-$number.json" || code=$? ;;
    4) echo "test $number: no blow counts" ;;
    6) echo "test $number: the recording ended early; start this script again to go on" ;;
    *) echo "test $number: percuss record failed with exit code $code" ;;
  esac
  [ "$code" -gt "$worst" ] && worst=$code
  [ "$code" -eq 0 ] || [ "$code" -eq 4 ] || break
  number=$((number + 1))
done
exit "$worst"
