#!/bin/sh
# Makes the pictures of docs/guide.md: each from the scene beside it, or those of the scenes that are named.
#
#   docs/guide/make.sh [SCENE.xml...]
set -eu
cd "$(dirname "$0")"
[ $# -gt 0 ] || set -- *.xml
for scene; do
    ../../daybreak render "$scene" --progress none -o "${scene%.xml}.png"
done
