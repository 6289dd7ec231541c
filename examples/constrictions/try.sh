#!/bin/sh
# Tries the program on a small mesh; the results are in the folder that is given.
#
#   sh try.sh FOLDER
set -eu

mesh=$(dirname "$0")/dumbbell.off
folder=${1:?give the name of a folder for the results}

constrictions check "$mesh"
constrictions detect "$mesh"
constrictions detect "$mesh" -o "$folder/curves"
constrictions certify "$mesh" --curves "$folder/curves/constrictions.json"
constrictions segment "$mesh" -o "$folder/parts" --format stl
constrictions view "$mesh" -o "$folder/dumbbell.html" || echo "This program was built without its viewer."
