#!/bin/sh
# For a computer without a screen, such as a single-board computer at a test stand. Records one hammer test after
# another. The exit code and the messages say whether each is complete.
#   record_unattended.sh DEVICE FOLDER [TESTS] [OPTION]...
# DEVICE is a name that "percuss devices" lists; sim:aluminium-bat simulates a device. TESTS is a number; without it,
# there is one test. Options go to percuss record; the analysis has the same --band.
set -u
if [ $# -lt 2 ]; then
  echo "usage: record_unattended.sh DEVICE FOLDER [TESTS] [OPTION]..." >&2
  exit 2
fi
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

# The document appears whole or not at all, so that a missing one is made again after a loss of power.
analyse() {
  percuss analyze "$1.h5" --json ${band:+--band "$band"} > "$1.json.part" && mv "$1.json.part" "$1.json"
}

mkdir -p "$folder" || exit 3
worst=0
number=1
while [ "$number" -le "$tests" ]; do
  test="$folder/test-$number"
  code=0
  if [ -e "$test.h5.journal" ]; then
    percuss record --resume "$test.h5" || code=$?  # the power failed during this test
  elif [ ! -e "$test.h5" ]; then
    percuss record -o "$test.h5" --device "$device" "$@" || code=$?
  elif [ -e "$test.json" ]; then
    number=$((number + 1))
    continue
  fi
  if [ "$code" -eq 0 ]; then
    analyse "$test" || code=$?
  fi
  case $code in
    0) ;;
    4) echo "test $number: no blow counts" ;;
    6) echo "test $number: the recording ended early; start this script again to go on" ;;
    *) echo "test $number: percuss failed with exit code $code" ;;
  esac
  [ "$code" -gt "$worst" ] && worst=$code
  [ "$code" -eq 0 ] || [ "$code" -eq 4 ] || break
  number=$((number + 1))
done
exit "$worst"
