# Thin over the `macram` command. `make demo` and `make test` set themselves up from a bare clone.
# Variables: SEED=7  WAVES=1  IMAGE=picture.png  CONFIG=configs/tiny.toml  OUT=folder  CASES=1000  PYTHON=python3.12

.DEFAULT_GOAL := help
SHELL := /bin/bash

PYTHON ?= python3
BIN := .venv/bin
STAMP := .venv/macram.stamp
MACRAM := $(BIN)/macram
CONFIG ?= configs/reference.toml

# Only what was given is passed on; the defaults live in the command. Make itself puts SEED and WAVES from
# its command line into the environment, where the benches that pytest starts find them.
SEED_ARG := $(if $(SEED),--seed $(SEED))
WAVES_ARG := $(if $(filter-out 0,$(WAVES)),--waves)
IMAGE_ARG := $(if $(IMAGE),--image "$(IMAGE)")
CASES_ARG := $(if $(CASES),--cases $(CASES))
OUT_ARG := $(if $(OUT),--out "$(OUT)")

# Simulator builds stay in the repository here; without make they go to the user's cache folder.
export MACRAM_BUILD_DIR ?= $(CURDIR)/build

.PHONY: help setup tools demo test test-fast sim rtl rtl-check lint lint-rtl bench synth bitstream regression formal \
	mutate clean

help:  ## this list
	@grep -E '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/^([a-z-]+):.*## (.*)/\1|\2/' | \
		awk -F'|' '{printf "  make %-10s %s\n", $$1, $$2}'
	@echo "  variables: SEED=7 WAVES=1 IMAGE=picture.png CONFIG=configs/tiny.toml OUT=folder PYTHON=python3.12"

setup: $(STAMP)  ## create .venv and install macram with everything it needs

$(STAMP): pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null || { echo \
		"macram needs Python 3.11 or newer, '$(PYTHON)' is $$($(PYTHON) --version 2>/dev/null || echo missing);" \
		"install one and name it: make PYTHON=python3.12" >&2; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || { echo \
		"$(PYTHON) has no venv module: apt-get install python3-venv" >&2; exit 1; }
	@test -x $(BIN)/python || $(PYTHON) -m venv .venv
	@echo "installing macram into .venv (PyTorch is the large part) ..."
	@$(BIN)/python -m pip install --progress-bar on --disable-pip-version-check -e '.[dev]'
	@touch $@

tools:
	@missing=; for tool in g++ make perl; do \
		command -v $$tool >/dev/null 2>&1 || missing="$$missing $$tool"; done; \
	test -z "$$missing" || { echo "missing:$$missing; install with: apt-get install$$missing" >&2; exit 1; }

demo: tools $(STAMP)  ## image -> network -> array -> comparison -> build/demo/report.html
	@$(MACRAM) demo $(IMAGE_ARG) $(OUT_ARG) $(SEED_ARG) $(WAVES_ARG)

test: tools $(STAMP)  ## every test
	@OMP_NUM_THREADS=1 $(BIN)/python -m pytest -n 2 --dist loadfile --no-loadscope-reorder

test-fast: $(STAMP)  ## the tests that need no simulator
	@$(BIN)/python -m pytest -m "not sim and not slow"

sim: tools $(STAMP)  ## the full-size reference layer and odd shapes on Verilator, with a table
	@$(MACRAM) sim $(IMAGE_ARG) $(OUT_ARG) $(SEED_ARG) $(WAVES_ARG)

rtl: $(STAMP)  ## write the Verilog of CONFIG into rtl/
	@$(MACRAM) rtl --config $(CONFIG) $(OUT_ARG)

rtl-check: $(STAMP)  ## fail if rtl/ is not what CONFIG gives
	@$(MACRAM) rtl --config $(CONFIG) $(OUT_ARG) --check

lint: $(STAMP)  ## ruff and mypy
	@$(BIN)/ruff check
	@$(BIN)/ruff format --check
	@$(BIN)/mypy

lint-rtl: tools $(STAMP)  ## verilator --lint-only -Wall on the exported Verilog
	@$(MACRAM) rtl --config $(CONFIG) $(OUT_ARG) --lint

regression: tools $(STAMP)  ## random layers, faults and resets with functional coverage (CASES=60)
	@$(MACRAM) verify regression $(OUT_ARG) $(SEED_ARG) $(CASES_ARG)

formal: $(STAMP)  ## every proof, and that broken gateware fails it
	@$(MACRAM) verify formal $(OUT_ARG)

mutate: tools $(STAMP)  ## break the gateware in 80 places, count what notices (hours; goes on where it stopped)
	@$(MACRAM) verify mutate $(OUT_ARG) $(SEED_ARG)

bench: tools $(STAMP)  ## measure build, simulation and golden model into build/bench/bench.json
	@$(MACRAM) bench $(OUT_ARG) $(SEED_ARG)

synth: $(STAMP)  ## count LUT, FF, DSP and BRAM of CONFIG by synthesis
	@$(MACRAM) synth $(CONFIG) $(OUT_ARG)

bitstream: $(STAMP)  ## ECP5 bitstream of configs/ecp5-85k.toml with its self-test
	@$(MACRAM) bitstream configs/ecp5-85k.toml $(OUT_ARG) $(SEED_ARG)

clean:  ## remove build products; .venv stays
	rm -rf build .pytest_cache .ruff_cache .mypy_cache .hypothesis
	find . -name __pycache__ -not -path './.venv/*' -prune -exec rm -rf {} +
