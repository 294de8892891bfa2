#!/bin/bash -eu
# Builds all fuzzers as OSS-Fuzz wants them: in $OUT, each with its seeds and the shared libraries that it needs. The
# environment gives $SRC, $OUT, $WORK, the compiler, its flags and $LIB_FUZZING_ENGINE. FUZZERS: only these.
cd "$SRC/pongsim"
mapfile -t names < <(cd test/fuzz/seeds && ls -d -- *)
[ -z "${FUZZERS:-}" ] || read -ra names <<<"$FUZZERS"
# the distribution's libraries are those of libstdc++
export CXXFLAGS="${CXXFLAGS//-stdlib=libc++/}"
cmake -S . -B "$WORK/build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER="$CXX" \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DPONGSIM_FUZZING_ENGINE="$LIB_FUZZING_ENGINE" -DPONGSIM_PYTHON=OFF -DPONGSIM_WEB=OFF
cmake --build "$WORK/build" --target "${names[@]/%/_fuzzer}"

mkdir -p "$OUT/lib"
for name in "${names[@]}"; do
  cp "$WORK/build/fuzz/${name}_fuzzer" "$OUT/"
  # the image in which they run has nothing but the C and C++ libraries
  ldd "$OUT/${name}_fuzzer" | awk '$3 ~ "^/" && $1 !~ /^(libc|libm|libdl|libpthread|librt|ld-linux.*)\.so/ { print $3 }' |
    xargs --no-run-if-empty cp --dereference --update --target-directory "$OUT/lib"
  patchelf --force-rpath --set-rpath '$ORIGIN/lib' "$OUT/${name}_fuzzer"
  zip --quiet --junk-paths "$OUT/${name}_fuzzer_seed_corpus.zip" "test/fuzz/seeds/$name"/*
  printf '[libfuzzer]\nmax_len = 65536\ntimeout = 20\nrss_limit_mb = 2048\n' >"$OUT/${name}_fuzzer.options"
done
