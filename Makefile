# One command each; every target does its own set-up (.venv, system libraries) first.

python := .venv/bin/python
# Qt and VTK on a screen in memory
screen := QT_API=pyside6 LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s "-screen 0 1400x1000x24 -noreset"

.PHONY: help run test test-core test-endurance test-plain test-program test-window lint types bench fuzz samples \
	screenshot setup-run setup-test setup-dev

help: ## say what there is
	@sed -nE 's/^([a-z-]+):.*## (.*)/  make \1\t\2/p' $(MAKEFILE_LIST) | expand -t 20

run: setup-run ## open the window on the built-in pair (no display: picture and numbers in out/)
	@.make/run

# each as long as the other half of the program's tests
endurance := $(addprefix tests/program/test_,same_on_every_machine.py extremes.py hostile_files.py \
	killed.py)

test: ## run all tests on two cores: core and window, then both halves of the program's
	@$(MAKE) --no-print-directory --keep-going --jobs 2 test-core test-window test-endurance \
		test-program

test-core: setup-test ## run the tests of the core, and of the window's parts that need no screen
	$(python) -m pytest tests/core tests/app

test-program: setup-test ## run the tests of whole programs, which start processes
	$(python) -m pytest tests/program $(addprefix --ignore=,$(endurance))

test-endurance: setup-test ## run the tests of what is odd, large, killed, or another machine
	$(python) -m pytest $(endurance)

test-plain: setup-test ## run tests of all kernels without compilation, where no index or overflow passes in silence
	NUMBA_DISABLE_JIT=1 $(python) -m pytest tests/core -m "plain and not large"

test-window: setup-test ## run the tests of the window
	$(screen) $(python) -m pytest tests/window

lint: setup-dev ## check style
	$(python) -m ruff check
	$(python) -m ruff format --check

types: setup-dev ## check types
	$(python) -m mypy

bench: setup-test ## measure speed and memory (ARGS=compare: that alone)
	$(python) -m tests.benchmarks $(ARGS)

fuzz: setup-test ## seek pairs of grids that break the merge, until stopped (ARGS="--seconds 600")
	$(python) -m tests.fuzz $(ARGS)

samples: setup-run ## write the built-in samples anew
	$(python) resources/make_samples.py

screenshot: setup-run ## write the picture of the window shown in the README
	$(screen) $(python) -m app.screenshot resources/window.png

setup-run setup-test setup-dev:
	@.make/setup $(@:setup-%=%)
