# One command for each thing that one does here. CMake does the work; this sets up what it needs.
#
#   make run  [SCENE=scenes/jacksboro.toml] [OUT=out/jacksboro]     JOBS=N limits parallel work,
#   make test                                                       NO_INSTALL=1 installs nothing
SCENE ?= scenes/jacksboro.toml
OUT ?= out/$(basename $(notdir $(SCENE)))
JOBS ?= $(shell nproc)
WERROR ?= OFF
# Their edges go through the Tessellation Tests' RTL.
COSIM_SCENES ?= jacksboro head donut etopo5 volcano cylinder

BUILD := build/release
PROGRAM := $(BUILD)/bin/repousse
MAKEFLAGS += --no-print-directory
.DEFAULT_GOAL := help
.PHONY: help run test bench cosim asan format tidy clean

help:
	@echo "make run     build the program and simulate SCENE ($(SCENE)) into OUT ($(OUT))"
	@echo "make test    build everything and run all tests, as CI does"
	@echo "make bench   run the benchmarks; their tables go to docs/bench.md"
	@echo "make cosim   the long co-simulation; its table goes to docs/cosim_results.md"
	@echo "make asan    the tests under AddressSanitizer and UndefinedBehaviorSanitizer"
	@echo "make format  clang-format over the sources"
	@echo "make tidy    clang-tidy over the sources"
	@echo "make clean   remove build/ and out/ (SystemC stays in its cache, the inputs in inputs/)"

run:
	@cmake/bootstrap.sh run
	@[ -e $(BUILD)/build.ninja ] || cmake --preset release
	@cmake --build --preset release --target repousse -j $(JOBS)
	@scenes/fetch.sh $(SCENE)
	@$(PROGRAM) sim $(SCENE) -o $(OUT)
	@echo "The picture is $(OUT)/frame.png"

test:
	@cmake/bootstrap.sh run test
	@cmake --preset release -DREPOUSSE_TESTS=ON -DREPOUSSE_BENCH=ON -DREPOUSSE_WERROR=$(WERROR)
	@cmake --build --preset release -j $(JOBS)
	@scenes/fetch.sh
	@ctest --preset release -j $(JOBS) --output-log $(BUILD)/Testing/ctest.log

bench:
	@cmake/bootstrap.sh run bench
	@cmake --preset release -DREPOUSSE_BENCH=ON
	@cmake --build --preset release --target repousse bench -j $(JOBS)
	@scenes/fetch.sh
	@testbench/bench/run.sh $(BUILD)/bench docs/bench.md

cosim:
	@cmake/bootstrap.sh run test
	@cmake --preset release
	@cmake --build --preset release --target repousse -j $(JOBS)
	@scenes/fetch.sh
	@$(PROGRAM) cosim --exhaustive $(addprefix --scene scenes/,$(addsuffix .toml,$(COSIM_SCENES))) \
		-o docs/cosim_results.md

asan:
	@cmake/bootstrap.sh run test
	@cmake --preset asan-ubsan -DREPOUSSE_TESTS=ON
	@cmake --build --preset asan-ubsan -j $(JOBS)
	@ctest --preset asan-ubsan -j $(JOBS)

format:
	@cmake/bootstrap.sh format
	@cmake/format.sh

tidy:
	@cmake/bootstrap.sh run test tidy
	@cmake --preset release -DREPOUSSE_TESTS=ON -DREPOUSSE_BENCH=ON
	@run-clang-tidy -quiet -p $(BUILD) -j $(JOBS) '$(CURDIR)/(datapath|tlm|testbench)/.*'

clean:
	@rm -rf build out
