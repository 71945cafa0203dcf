# SPDX-License-Identifier: Apache-2.0
# A thin face on CMake's presets: each target sets up what it needs, and no more.
PURPOSE ?= build report test
clang_format = git ls-files --cached --others --exclude-standard '*.cpp' '*.hpp' \
  | xargs clang-format-14

.PHONY: all deps build report test install format format-check tidy debug clean help
all: build

deps: ## install the packages of PURPOSE="build report test check"
	@.ci/deps $(PURPOSE)

# TRIBOCHECK_BUILD_TESTS is left as the last `make test` set it.
build: ## build/release/tribocheck
	@.ci/deps build
	cmake --preset release
	cmake --build --preset release --target tribocheck

report: ## solve the paper's scenes and draw its figures: reports/out/index.html
	@.ci/deps build report
	@$(MAKE) --no-print-directory build
	build/release/tribocheck report

test: ## build and run all tests
	@.ci/deps build test
	cmake --preset release -DTRIBOCHECK_BUILD_TESTS=ON
	cmake --build --preset release
	ctest --preset release

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

tidy: ## clang-tidy on the model and the program
	@.ci/deps build check
	cmake --preset tidy
	cmake --build --preset tidy -- -k 0

clean: ## remove build/ and the last report
	rm -rf build reports/out

help: ## this list
	@sed -n 's/^\([a-z]*\):.*## /\1\t/p' $(MAKEFILE_LIST) | expand -t 12
