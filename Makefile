# SPDX-License-Identifier: Apache-2.0
# A thin face on CMake's presets: each target sets up what it needs, and no more.
PURPOSE ?= build report test
clang_format = git ls-files --cached --others --exclude-standard '*.cpp' '*.hpp' \
  | xargs clang-format-14

.PHONY: all deps build references references-check report test test-slow install format format-check tidy tidy-program debug clean help
all: build

deps: ## install the packages of PURPOSE="build report test check"
	@.ci/deps $(PURPOSE)

# TRIBOCHECK_BUILD_TESTS is left as the last `make test` set it.
build: ## build/release/tribocheck
	@.ci/deps build
	cmake --preset release
	cmake --build --preset release --target tribocheck

references: ## make the tables of reference/exact anew, in ball arithmetic; takes some ten minutes
	@.ci/deps build references
	cmake --preset release -DTRIBOCHECK_BUILD_REFERENCES=ON
	cmake --build --preset release --target generate_references
	build/release/reference/generators/generate_references reference/exact

references-check: ## make a sample of the rows again and compare bytes
	@.ci/deps build references
	cmake --preset release -DTRIBOCHECK_BUILD_REFERENCES=ON
	cmake --build --preset release --target generate_references
	build/release/reference/generators/generate_references reference/exact --sample 8 --seed 1

report: ## solve the paper's scenes and draw its figures: reports/out/index.html
	@.ci/deps build report
	@$(MAKE) --no-print-directory build
	build/release/tribocheck report

test: ## build and run all tests
	@.ci/deps build test
	cmake --preset release -DTRIBOCHECK_BUILD_TESTS=ON
	cmake --build --preset release
	ctest --preset release

test-slow: build ## stream ten million lines in flat memory; takes some two minutes
	cd reports/tests && TRIBOCHECK=$(CURDIR)/build/release/tribocheck TRIBOCHECK_LINES=10000000 \
	  python3 -B -m unittest -v test_stream_slow

debug: ## build with sanitizers and run the quick tests
	@.ci/deps build test
	cmake --preset debug
	cmake --build --preset debug
	ctest --preset debug

install: build ## install under PREFIX, or /usr/local
	cmake --install build/release $(if $(PREFIX),--prefix "$(PREFIX)")

format: ## lay out every C++ file with clang-format
	@.ci/deps check
	$(clang_format) -i

format-check:
	$(clang_format) --dry-run -Werror

tidy: ## clang-tidy on the model and each of its headers
	@.ci/deps build check
	cmake --preset tidy
	cmake --build --preset tidy -- -k 0

tidy-program: tidy ## the same on the program; takes minutes
	cmake --build --preset tidy --target tribocheck -- -k 0

clean: ## remove build/ and the last report
	rm -rf build reports/out

help: ## this list
	@sed -n 's/^\([a-z-]*\):.*## /\1\t/p' $(MAKEFILE_LIST) | expand -t 16
