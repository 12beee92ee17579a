#!/bin/sh
# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: GPL-3.0-or-later
# The tables of docs/peers.md: judge_contestants.sh PROGRAMS OUT [POSES]. PROGRAMS: the folder with pcm and contestants/;
# OUT: a folder for surfaces, poses and what the oracle says of each engine that is there.
set -eu
programs=$(realpath "$1")
poses=${3:-12096}
mkdir -p "$2/surfaces"
cd "$2"
pcm="$programs/pcm"

# surface NAME SHAPE PARAMETER...
surface() {
  name=$1
  shift
  "$pcm" mesh make "$@" -o "surfaces/$name.obj"
}

# judge FOLDER COMMAND OPTION...: wrong answers are no failure here.
judge() {
  folder=$1
  command=$2
  shift 2
  status=0
  "$pcm" judge --command "$command" --poses poses --out "$folder" "$@" >"$folder.txt" 2>&1 || status=$?
  echo "$folder: $(tail -n 1 "$folder.txt")"
  [ "$status" -le 1 ] || exit "$status"
}

# contestant FOLDER ENGINE OPTION...: where it was built.
contestant() {
  folder=$1
  engine=$2
  shift 2
  if [ -x "$programs/contestants/$engine" ]; then
    judge "$folder" "'$programs/contestants/$engine'" "$@"
  else
    echo "$engine: not installed"
  fi
}

# Closed, orientable and free of self-intersections, as every contestant asks. Coordinates are dyadic where the shape
# lets them be.
surface cube box
surface gridded-cube gridded_box --subdivisions_x=2 --subdivisions_y=2 --subdivisions_z=2
surface plate plate --thickness=0.25 --subdivisions_x=2 --subdivisions_y=2
surface icosphere icosphere --radius=0.5 --level=1
surface wedge wedge --tilt_degrees=45 --subdivisions=1
surface cylinder cylinder --segments=12 --bands=1 --cap_rings=1
surface torus torus --ring_radius=0.5 --tube_radius=0.25 --segments=8 --tube_segments=6
surface bubble bubble
set --
for pair in 'cube cube' 'gridded-cube plate' 'icosphere plate' 'icosphere icosphere' 'wedge cube' 'cylinder cube' \
  'torus torus' 'bubble bubble'; do
  set -- "$@" --pair "surfaces/${pair% *}.obj" "surfaces/${pair#* }.obj"
done
"$pcm" poses --out poses --poses "$poses" --law elastic --mode E --scheme barycentric "$@"

contestant fcl fcl
contestant embree embree
# Single precision: 8 ulps of it are 2^32 of double precision.
contestant ode ode --ulps 4294967296
contestant bullet bullet --ulps 4294967296
# Volumes are summed up about the origin, 1e-12 of a body's own away from it; intersection points are rounded.
contestant cgal cgal --absolute volume=1e-12,area=1e-12 --tolerance volume=1e-9,area=1e-9
# Its law is another one: how far off forces are is read from how many are wrong at each tolerance. A neighbouring answer
# is looked for once.
contestant simbody simbody --tolerance force=0.01,torque=0.01
for part in 0.001 0.1; do
  contestant "simbody-$part" simbody --tolerance "force=$part,torque=$part" --ulps 0
done
# Our own; and the published algorithms by the measure of `pcm verify --engine`, which looks for no neighbours.
judge pcm "'$pcm' answer"
for algorithm in published-2003 published-2023; do
  judge "$algorithm" "'$pcm' answer --engine $algorithm" --tolerance force=1e-9,torque=1e-9 --ulps 0
done
