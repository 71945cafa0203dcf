# SPDX-License-Identifier: Apache-2.0
# Short names for CMake's presets. Each target prepares only what it needs.
PURPOSE ?= build report test
FUZZ_SECONDS ?= 900
clang_format = git ls-files --cached --others --exclude-standard '*.cpp' '*.hpp' \
  | xargs clang-format-14
# The files in a package have the date of its commit.
same_dates = SOURCE_DATE_EPOCH=$$(git log -1 --format=%ct 2>/dev/null || date +%s)

.PHONY: all deps build film-survey point-survey paper-films references references-check pieces pieces-check report test test-elsewhere arm64 thread-check test-slow ledger bench bench-sweep work-precision gate-program gate gate-baseline gate-proof bench-rates profile fuzz-short fuzz manifest mutants faults numbers diagnosis additions field live live-check live-firefox verify-full stress baseline install data package-check package format format-check tidy tidy-program debug clean help
all: build

##@ Start here
report: ## solve the paper's scenes, draw its figures: reports/out/index.html; some 3 minutes the first time
	@.ci/deps build report
	@$(MAKE) --no-print-directory build
	build/release/tribocheck field reference/field -o reports/out/field.html
	build/release/tribocheck report \
	  --commit "$$(git describe --always --dirty --abbrev=40 --exclude '*' 2>/dev/null)"

test: ## build, run all tests, hold what ran to the manifest of checks; some 20 minutes the first time
	@.ci/deps build test
	cmake --preset release -DTRIBOCHECK_BUILD_TESTS=ON
	cmake --build --preset release
	ctest --preset release --output-junit ctest.xml --test-output-size-passed 1000000
	python3 verification/gates/inventory.py build/release/ctest.xml

##@ The program
deps: ## install the packages of PURPOSE, as "build report test"; .ci/packages has a list of each
	@.ci/deps $(PURPOSE)

# This target does not change TRIBOCHECK_BUILD_TESTS, which `make test` sets.
build: ## build the program: build/release/tribocheck
	@.ci/deps build
	cmake --preset release
	cmake --build --preset release --target tribocheck

install: ## install under PREFIX (default /usr/local)
	@if [ "$(PREFIX)" -ef . ]; then \
	  echo "make install: PREFIX is the folder of the sources; allowed: any other folder" >&2; exit 2; fi
	@$(MAKE) --no-print-directory build
	cmake --install build/release $(if $(PREFIX),--prefix "$(PREFIX)")

package: ## make packages of Debian, in build/package/packages; some four minutes
	@.ci/deps build python octave package
	$(same_dates) cmake --preset package
	$(same_dates) cmake --build --preset package --target tribocheck tribocheck_pages
	rm -rf build/package/packages
	cd build/package && $(same_dates) cpack
	lintian --fail-on error --tag-display-limit 0 --allow-root build/package/packages/*.deb

package-check: package ## install the packages on a fresh Debian, use them, remove them without a trace; some five minutes
	@.ci/deps package-check || echo "package-check: going on with what is installed" >&2
	reports/bindings/packages/check build/package/packages

data: build ## pack certified values, cases, solved films and mistakes, to be read without the program: build/tribocheck-data-VERSION.zip
	/usr/bin/python3 -B reports/bindings/packages/data.py build/release/tribocheck build

clean: ## remove build/ and the last report
	rm -rf build reports/out

help: ## print this list
	@awk -F ':.*## ' '/^##@ / { printf "\n%s\n", substr($$0, 5) } \
	  /^[a-z0-9-]+:.*## / { printf "  %-17s %s\n", $$1, $$2 }' $(MAKEFILE_LIST)

##@ What is right
test-elsewhere: ## run the built tests as on a machine without AVX-512, and on one without AVX2 and FMA; some 15 minutes
	.ci/test-elsewhere

thread-check: ## four threads call libtribocheck.so at once under ThreadSanitizer; some three minutes
	@.ci/deps build check
	cmake --preset threads
	cmake --build --preset threads
	clang-14 -std=c99 -g -fsanitize=thread -Ireports/bindings -Iverification/conformance reports/tests/library_user.c \
	  -Lbuild/threads/reports/bindings -Wl,-rpath,$(CURDIR)/build/threads/reports/bindings -ltribocheck -lm -o build/threads/library_user
	build/threads/library_user threads reference/published/rough.toml

arm64: build ## cross compile program, packages and tests for arm64 in a Debian of its own, run them under qemu, compare answers; some 20 minutes, of which the Debian is half
	$(same_dates) .ci/arm64

test-slow: build ## run ten million lines, a billion points, 300 kills, 150 tries, 200 pairs, 200 attacks, 500 forged results, each write failing, the scripts of CI in a clean root; some 40 minutes
	@.ci/deps test
	cd reports/tests && TRIBOCHECK=$(CURDIR)/build/release/tribocheck TRIBOCHECK_ROOT=$(CURDIR) \
	  TRIBOCHECK_LINES=10000000 TRIBOCHECK_POINTS=1000000000 TRIBOCHECK_KILLS=100 TRIBOCHECK_TRIES=150 \
	  TRIBOCHECK_PAIRS=200 TRIBOCHECK_ATTACKS=200 TRIBOCHECK_FORGED=500 TRIBOCHECK_FAILED_WRITES=1 \
	  /usr/bin/python3 -B -m unittest -v test_stream_slow test_sweep_memory_slow test_sweep_faults.Killed \
	  test_sweep_pairs test_sweep_files.Shared test_sweep_forged test_sweep_writes \
	  test_sweep_join test_sweep_ranks
	cd verification/tests/install && TRIBOCHECK_BUILD=$(CURDIR)/build/release TRIBOCHECK_ROOT=$(CURDIR) CMAKE=cmake \
	  /usr/bin/python3 -B -m unittest -v test_ci_files_slow.InItsRoot

verify-full: ## run all verification, the slow parts too, and say what each took; some 25 minutes
	.ci/verify-full

stress: ## hold ten million random points to long double: writes reference/baselines/stress.json; 4 to 20 minutes by the machine
	@.ci/deps build test
	cmake --preset release -DTRIBOCHECK_BUILD_TESTS=ON
	cmake --build --preset release --target model_stress
	build/release/verification/tests/model_stress --points 10000000 --seed 2 --threads $$(nproc) \
	  --commit "$$(git describe --always --dirty --abbrev=40 --exclude '*')" \
	  --out reference/baselines/stress.json

film-survey: build ## solve 300 random line contacts to four tolerances, judge the stated errors: half an hour, goes on where it was stopped
	cmake --preset release -DTRIBOCHECK_BUILD_TESTS=ON
	cmake --build --preset release --target film_survey
	verification/gates/film_survey.py build/release/verification/tests/film_survey \
	  --out reference/baselines/film_survey.json

point-survey: build ## solve 200 random point contacts, hold 60 to finer and longer grids: an hour and a half of one core, goes on where it was stopped
	cmake --preset release -DTRIBOCHECK_BUILD_TESTS=ON
	cmake --build --preset release --target film_survey
	verification/gates/film_survey.py build/release/verification/tests/film_survey --points \
	  --out reference/baselines/point_survey.json

paper-films: build ## solve the starved films of the paper's surfaces over their speeds: a quarter of an hour on one core, goes on where it was stopped
	verification/gates/paper_films.py build/release/tribocheck --out reference/baselines/paper_films.json

ledger: build ## write today's verdicts on the paper's claims to reference/baselines/ledger.csv, for you to commit
	build/release/tribocheck reproduce --ledger none --format csv > build/ledger.csv
	mv build/ledger.csv reference/baselines/ledger.csv

baseline: build ## write the accuracy that the ratchet holds: reference/baselines/accuracy.json
	@mkdir -p reference/baselines
	build/release/tribocheck verify --format json > build/accuracy.json
	printf '{"commit": "%s",\n"date": "%s",\n"environment": {"compiler": "%s", "cpu": "%s"},\n%s\n' \
	  "$$(git describe --always --dirty --abbrev=40 --exclude '*')" "$$(date -u +%F)" \
	  "$$(g++ --version | head -1)" "$$(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -1)" \
	  "$$(sed '1s/.*"quantities"/"quantities"/' build/accuracy.json)" > reference/baselines/accuracy.json

manifest: ## write verification/gates/manifest.tsv anew, from what the last `make test` ran
	python3 verification/gates/inventory.py build/release/ctest.xml --write

mutants: ## draw SAMPLE=20261123 (a date) of wrong changes, see how many the tests notice; the copy half an hour, then parts of MINUTES=60 that add up
	@.ci/deps build test bench check
	cmake --preset release -DTRIBOCHECK_BUILD_TESTS=ON -DTRIBOCHECK_BUILD_BENCHMARKS=ON
	verification/gates/mutants/run.py sample $(if $(SAMPLE),--seed $(SAMPLE)) --minutes $(or $(MINUTES),60)

faults: ## plant every fault of verification/gates/faults, see it caught; three hours; OLDEST=N: the N oldest verdicts
	@.ci/deps build test
	verification/gates/faults/plant.py $(if $(OLDEST),--oldest $(OLDEST)) --out reference/baselines/planted_faults.json

numbers: build ## write reference/baselines/numbers.json, all bits that numbers_version stands for, after it was raised; some seconds
	@.ci/deps test
	cd reports/tests && TRIBOCHECK=$(CURDIR)/build/release/tribocheck /usr/bin/python3 -B kept_numbers.py

field: build ## ask the solvers of reports/field, each in a sandbox: writes reference/field; SOURCES=DIR has their checkouts; half a minute once they are cloned
	@.ci/deps build test field
	cmake --preset release -DTRIBOCHECK_BUILD_TESTS=ON
	cmake --build --preset release --target tribocheck c_plugin cpp_registration fortran_plugin own_model own_model_plugin
	reports/field/run.py $(if $(SOURCES),--sources "$(SOURCES)")

diagnosis: build ## put every fake, alone and together, to verify --subject: writes reference/baselines/diagnosis.json; two or three minutes
	@.ci/deps build test
	cmake --preset release -DTRIBOCHECK_BUILD_TESTS=ON
	cmake --build --preset release --target tribocheck diagnosis_test
	cd reports/tests && TRIBOCHECK=$(CURDIR)/build/release/tribocheck TRIBOCHECK_ROOT=$(CURDIR) \
	  TRIBOCHECK_SUBJECTS=$(CURDIR)/build/release/verification/conformance/subjects \
	  /usr/bin/python3 -B diagnosis_ledger.py $(CURDIR)/reference/baselines/diagnosis.json \
	  $(CURDIR)/build/release/verification/tests/diagnosis_test

additions: ## add a field, law, closure, output, criterion, function and section to a scratch copy, see each work, count its files; some four minutes
	@.ci/deps build report references test
	verification/gates/additions/prove.py

fuzz-short: ## run each fuzz target on a fixed number of inputs; half a minute, the build some minutes
	@.ci/deps build test check
	cmake --preset clang
	cmake --build --preset fuzz
	verification/tests/stress/fuzz/run build/clang

fuzz: ## run all fuzz targets beside each other for FUZZ_SECONDS (default 900)
	@.ci/deps build test check
	cmake --preset clang
	cmake --build --preset fuzz
	verification/tests/stress/fuzz/run build/clang $(FUZZ_SECONDS)

debug: ## build with g++ and its sanitizers, and run the quick tests (.ci/run does so with clang)
	@.ci/deps build test
	cmake --preset debug
	cmake --build --preset debug
	ctest --preset debug

##@ What is fast
bench: ## measure speed and true error of every contender; FILTER=RE chooses, PLUGIN=LIB adds one; some five minutes
	@.ci/deps build bench
	cmake --preset release -DTRIBOCHECK_BUILD_BENCHMARKS=ON
	cmake --build --preset release --target tribocheck tribocheck_bench
	build/release/tribocheck bench $(if $(FILTER),--filter '$(FILTER)') $(if $(PLUGIN),--plugin '$(PLUGIN)')

bench-sweep: ## measure sweeps beside the kernels, threads, ranks, memory; writes reference/baselines/sweep.json; some six minutes
	@.ci/deps build bench
	cmake --preset release -DTRIBOCHECK_BUILD_BENCHMARKS=ON
	cmake --build --preset release --target tribocheck tribocheck_bench_sweep
	benchmarks/sweep/scaling.py build/release

work-precision: ## measure true error against work, draw it: reports/out/work_precision; some seven minutes; JOBS=RE chooses, as point_film
	@.ci/deps build bench
	cmake --preset release -DTRIBOCHECK_BUILD_BENCHMARKS=ON
	cmake --build --preset release --target tribocheck_work_precision
	build/release/benchmarks/tribocheck_work_precision --out reports/out/work_precision $(if $(JOBS),--jobs '$(JOBS)') \
	  --commit "$$(git describe --always --dirty --abbrev=40 --exclude '*')" --date "$$(date -u +%F)" \
	  $(if $(PLUGIN),--plugin '$(PLUGIN)',--baseline reference/baselines/work_precision.json)
	benchmarks/work_precision/draw reports/out/work_precision

# valgrind is on the list bench.txt. Where it cannot be installed, the gates run without it.
GATE_PROGRAM = build/release/tribocheck_gate_kernels
gate-program:
	@.ci/deps build bench || echo "gates: going on with what is installed" >&2
	cmake --preset release -DTRIBOCHECK_BUILD_BENCHMARKS=ON
	cmake --build --preset release --target tribocheck_gate_kernels

gate: gate-program ## hold work, instructions and CPU time to the baseline, or to BASE=PROGRAM; some 20 s
	benchmarks/gates/gate.py $(GATE_PROGRAM) $(if $(GATES),--gates $(GATES)) $(if $(BASE),--base $(BASE))

gate-baseline: gate-program ## write what the gates hold: reference/baselines/performance.json; some 10 s
	benchmarks/gates/gate.py $(GATE_PROGRAM) --update

gate-proof: gate-program ## plant more work, see each gate fail: writes reference/baselines/gates.json; a minute or two
	benchmarks/gates/prove.py $(GATE_PROGRAM) --out reference/baselines/gates.json

bench-rates: build ## count how often `tribocheck bench` is right of solvers as before, 10 % and 25 % slower: writes reference/baselines/bench_rates.json; an hour or less
	benchmarks/gates/solver_rates.py build/release/tribocheck --out reference/baselines/bench_rates.json

profile: gate-program ## run callgrind on the inner loop: build/profile/callgrind.out, and how to look at it
	benchmarks/gates/profile $(GATE_PROGRAM) build/profile

##@ Numbers made anew
references: ## make the tables of reference/exact and reference/ehl anew, and rows that the tables of points lack (all: an hour and a half); some eight minutes
	@.ci/deps build references
	cmake --preset release -DTRIBOCHECK_BUILD_REFERENCES=ON
	cmake --build --preset release --target generate_references generate_line_films generate_point_films generate_point_films_second_method
	build/release/reference/generators/generate_references reference/exact
	build/release/reference/generators/generate_line_films reference/ehl/line_films.csv
	build/release/reference/generators/generate_line_films reference/ehl/line_films_between.csv --between
	build/release/reference/generators/generate_line_films reference/ehl/line_films_compressible.csv --compressible
	build/release/reference/generators/generate_point_films_second_method reference/ehl/point_films_second_method.csv
	build/release/reference/generators/generate_point_films reference/ehl/point_films.csv
	build/release/reference/generators/generate_point_films reference/ehl/point_films_compressible.csv --compressible
	build/release/reference/generators/generate_point_films reference/ehl/point_films_between.csv --between

references-check: ## make SAMPLE rows of each exact table and of line films again (default 8), and 5 of point films, and compare them
	@.ci/deps build references
	cmake --preset release -DTRIBOCHECK_BUILD_REFERENCES=ON
	cmake --build --preset release --target generate_references generate_line_films generate_point_films
	build/release/reference/generators/generate_references reference/exact --sample $(or $(SAMPLE),8) --seed 1
	build/release/reference/generators/generate_line_films reference/ehl/line_films.csv --sample $(or $(SAMPLE),8) --seed 1
	build/release/reference/generators/generate_point_films reference/ehl/point_films.csv --sample 4 --seed 1
	build/release/reference/generators/generate_point_films reference/ehl/point_films_compressible.csv --compressible --sample 1 --seed 1

pieces: ## make the polynomials of the moment kernels anew, with their proven error; two or three minutes
	@.ci/deps build references
	cmake --preset release -DTRIBOCHECK_BUILD_REFERENCES=ON
	cmake --build --preset release --target generate_moment_pieces
	build/release/reference/generators/generate_moment_pieces model/src

pieces-check: ## make them again in another folder, and compare bytes
	@.ci/deps build references
	cmake --preset release -DTRIBOCHECK_BUILD_REFERENCES=ON
	cmake --build --preset release --target generate_moment_pieces
	mkdir -p build/pieces
	build/release/reference/generators/generate_moment_pieces build/pieces
	cmp build/pieces/gaussian_moment_pieces.inc model/src/gaussian_moment_pieces.inc

live: ## compile the model to WebAssembly for the page's live part: reports/live/tribocheck.wasm; a minute
	@.ci/deps build live
	cmake --preset release
	cmake --build --preset release --target model/film_tables.inc
	reports/live/make_live.py build/release

live-check: ## compile it again in build/live, and compare bytes
	@.ci/deps build live
	cmake --preset release
	cmake --build --preset release --target model/film_tables.inc
	reports/live/make_live.py build/release --check

live-firefox: build ## try the live part in Firefox: needs firefox-esr, and npm for puppeteer-core, which drives it
	@command -v firefox-esr npm >/dev/null || { echo "live-firefox: skipped, as firefox-esr or npm is not there" >&2; exit 0; }; \
	  npm install --silent --no-audit --no-fund --ignore-scripts --prefix build/live/npm puppeteer-core@24.43.1 || \
	  { echo "live-firefox: skipped, as npm has no puppeteer-core" >&2; exit 0; }; \
	  build/release/tribocheck report --section live --out build/live/page && \
	  node reports/live/firefox.mjs build/live/page/index.html build/live/npm/node_modules

##@ The text
format: ## lay out every C++ file with clang-format
	@.ci/deps check
	$(clang_format) -i

format-check: ## say which files clang-format would change
	$(clang_format) --dry-run -Werror

tidy: ## run clang-tidy on the model and each of its headers
	@.ci/deps build check
	cmake --preset tidy
	cmake --build --preset tidy -- -k 0

tidy-program: tidy ## run clang-tidy on the program too; minutes
	cmake --build --preset tidy --target tribocheck -- -k 0
