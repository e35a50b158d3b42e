#!/bin/sh
# Makes every picture of the documentation from computed geometry: gallery.sh GNOMON [FOLDER]
# GNOMON is the program; FOLDER (docs/pictures) gets the pictures. ./bootstrap gallery builds the program and runs this.
set -eu
gnomon=$(realpath "$1")
cd "$(dirname "$0")"
folder=$(realpath -m "${2:-pictures}")
mkdir -p "$folder"
examples=$PWD/../examples

# scene SCENE PICTURE [OPTION...]
scene() {
  file=$examples/$1.scene.json
  picture=$folder/$2
  shift 2
  "$gnomon" render "$file" --out "$picture" --size 960x720 "$@"
}

scene figure_4_16 figure_4_16.png
scene figure_4_17 figure_4_17.png
scene figure_4_18_no_umbra figure_4_18.png
scene figure_4_19 figure_4_19.png
scene figure_4_20_one_penumbra figure_4_20.png
scene figure_4_21 figure_4_21.png
"$gnomon" render "$examples/figure_4_22.scene.json" --out "$folder/figure_4_22.png"
scene cornell_box cornell_box.png
scene cornell_box irradiance.png --colour irradiance
scene letter_block letter_block.png

# image SCENE [OPTION...]: what a scene's camera sees.
image() {
  file=$1
  shift
  "$gnomon" image "$examples/$file.scene.json" --quiet "$@"
}

image still_life --out "$folder/still_life.png" --samples 2
for name in phong_1_7 phong_2_4 phong_4_18; do image papers/$name --out "$folder/$name.png" --samples 3; done
for mode in flat gouraud phong; do
  image papers/phong_4_7 --out "$folder/phong_4_7_$mode.png" --samples 3 --shading $mode
done
for name in p93_3_8 p93_3_10; do image papers/$name --out "$folder/$name.png" --samples 2; done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# beside SCENE POINTS: a scene, and the same with points for its lights; prints what they differ by.
beside() {
  image "papers/$1" --out "$folder/$1.png" --exposure "$3"
  image "papers/$1" --out "$folder/$1_points.png" --exposure "$3" --lights "points:$2"
  image "papers/$1" --out "$work/exact.pfm"
  image "papers/$1" --out "$work/points.pfm" --lights "points:$2"
  printf '%s, %s points: ' "$1" "$2"
  ./compare_pictures.py "$work/exact.pfm" "$work/points.pfm"
}

beside pa90_sphere 7 5
beside p93_desk 7 3.5
beside p93_cafeteria 3 3

# finer SCENE EXPOSURE: prints what meshes twice as fine would change.
./papers_scenes.py "$work/finer" 2
finer() {
  image "papers/$1" --out "$work/this.pfm"
  "$gnomon" image "$work/finer/$1.scene.json" --quiet --out "$work/finer.pfm"
  printf '%s, meshes twice as fine: ' "$1"
  ./compare_pictures.py "$work/this.pfm" "$work/finer.pfm" "$2"
}

finer pa90_sphere 5
finer phong_4_18 1.56

# divided SCENE PICTURE: the receivers of a scene with their regions and the lines of each order.
divided() {
  "$gnomon" receivers "$examples/$1.scene.json" --out "$work/$1" --quiet
  "$gnomon" render "$work/$1" --out "$folder/$2" --size 960x720
}

divided figure_4_23 figure_4_23.png
divided figure_4_24_a figure_4_24_a.png
divided figure_4_24_b figure_4_24_b.png
divided cornell_box cornell_receivers.png

# Pictures by ParaView, where pvbatch and its Python modules are.
if command -v pvbatch >/dev/null; then
  cd "$work"
  floor="--box -5,-4,0,5,4,0.001 --shape 201,161,1 --quiet"
  "$gnomon" shadow "$examples/figure_4_22.scene.json" --box -5,-4,0,5,4,5 --out out --quiet
  # shellcheck disable=SC2086 # a list of words
  "$gnomon" grid "$examples/figure_4_22.scene.json" $floor --out floor.vti
  # shellcheck disable=SC2086
  "$gnomon" grid "$examples/two_lamps.scene.json" $floor --out two.vti
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvbatch "$OLDPWD/paraview_pictures.py" "$folder"
  xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" pvbatch figure_4_24_a/view.py \
    --screenshot "$folder/paraview_receivers.png"
else
  echo "gallery: pvbatch (Debian package paraview) is not installed; the pictures by ParaView stay as they are"
fi
