#!/usr/bin/env bash
# own_peers.sh FOLDER CXX FLAGS: Bullet and ODE, both in float, compiled with these flags from the sources of the distribution's
# packages, which apt fetches into FOLDER and nowhere else. FOLDER/done says what was made of what.
set -eu
folder=$1 compiler=$2 flags=$3
rm -rf "$folder/done"
mkdir -p "$folder/apt/lists/partial" "$folder/apt/cache" "$folder/apt/parts" "$folder/source"
cd "$folder"
here=$PWD

command -v apt-get >/dev/null || { echo "sources are fetched by apt, and there is no apt here"; exit 1; }
# The same places that packages come from, asked for sources.
for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
  if [ -f "$file" ]; then sed -n 's/^deb /deb-src /p' "$file" >"apt/parts/of_${file##*/}"; fi
done
for file in /etc/apt/sources.list.d/*.sources; do
  if [ -f "$file" ]; then sed 's/^Types:.*/Types: deb-src/' "$file" >"apt/parts/of_${file##*/}"; fi
done
own_apt() {
  apt-get -q -o Dir::Etc::sourcelist="$here/apt/none" -o Dir::Etc::sourceparts="$here/apt/parts" -o Dir::State::lists="$here/apt/lists" \
    -o Dir::Cache="$here/apt/cache" -o APT::Sandbox::User=root "$@"
}
own_apt update || true # a place that has no sources is no reason to stop
for name in bullet ode; do
  rm -rf "$name" "source/$name"_*
  mkdir "$name"
  (cd source && own_apt source --download-only "$name")
  for archive in "source/$name"_*.orig.tar.[bgx]z*; do tar -xf "$archive" -C "$name" --strip-components=1; done
done

# Each library of Bullet is one file that includes the others.
for part in LinearMath BulletCollision BulletDynamics; do
  # shellcheck disable=SC2086  # a list of flags
  "$compiler" $flags -w -Ibullet/src -c "bullet/src/bt${part}All.cpp" -o "$part.o"
done
rm -f libbullet.a
ar rcs libbullet.a LinearMath.o BulletCollision.o BulletDynamics.o
cmake -S ode -B ode_build -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags -w" \
  -DCMAKE_POLICY_VERSION_MINIMUM=3.5 -DBUILD_SHARED_LIBS=OFF -DODE_DOUBLE_PRECISION=OFF -DODE_WITH_DEMOS=OFF -DODE_WITH_TESTS=OFF
cmake --build ode_build --target ODE --parallel 2
basename -s .dsc source/*.dsc >'done'
