#!/bin/sh
# Makes the pictures of docs/guide.md: each from the scene beside it, or those of the scenes that are named. They are
# reduced to 256 colours, a third of the size; this needs python 3 with pillow.
#
#   docs/guide/make.sh [SCENE.xml...]
set -eu
cd "$(dirname "$0")"
[ $# -gt 0 ] || set -- *.xml
for scene; do
    picture=${scene%.xml}.png
    ../../daybreak render "$scene" --progress none -o "$picture"
    python3 -c 'import sys; from PIL import Image
picture = Image.open(sys.argv[1]).convert("RGB")
picture.quantize(256, method=Image.Quantize.MEDIANCUT).save(sys.argv[1], optimize=True)' "$picture"
done
