# run: make the environment, derive, generate, compile, verify one model, and fly the paper's Table 1 with it.
# quick: style and types, a law of each room, and the tests of what was edited since BASE, in a minute on two cores.
# test: every test, in one pool, a file of tests at a time and the dearest first; tests/test_promises.py among them
# holds what is committed against its source, and verifies every model, and holds style and types.
VENV := .venv
BIN := $(VENV)/bin
PYTHON ?= python3
EXTRAS ?= all
BENCH := .venv-bench
SITE := .venv-site
PEERS := symforce wrenfold casadi sympy filterpy python-ins simdkalman numba jax control gtsam allantools
COUNTING := unicorn pyelftools pycparser

.NOTPARALLEL:
.PHONY: run quick test generated check evidence proofs bench cross-checks site clean tools announce

run: announce $(VENV)/.installed
	$(BIN)/boresight generate
	$(BIN)/boresight equations
	$(BIN)/boresight verify euler-matching
	$(BIN)/boresight study euler-table -o out/euler-table

announce:
	@test -e $(VENV)/.installed || echo "make: installs 1 GB of packages into $(VENV) first, once"
	@echo "make run: takes about 22 s of processor time; figures go to out/euler-table"

quick: $(VENV)/.tested
	@$(BIN)/python tests/quick.py $(BASE)

test: $(VENV)/.tested
	$(BIN)/python -m pytest -n auto tests

# What is generated, held against what is committed; with VENV and PYTHON of another version too.
generated: $(VENV)/.installed
	$(BIN)/boresight generate --check

check: $(VENV)/.tested
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

evidence: $(VENV)/.tested
	$(BIN)/python -m boresight.evidence

# Bounds on rounding over the whole box, by Gappa; with COQ=--coq Coq checks those of the small lists.
proofs: $(VENV)/.tested
	$(BIN)/python -m boresight.evidence.proofs $(COQ)

# Boresight beside its peers, in an environment of their own; the table goes into docs/benchmarks.md.  Never in CI.
bench: $(BENCH)/.installed
	$(BENCH)/bin/python -m benchmarks.peers --page docs/benchmarks.md
	$(BENCH)/bin/python -m benchmarks.call
	$(BENCH)/bin/python -m benchmarks.lanes
	$(BENCH)/bin/python -m benchmarks.epoch
	$(BENCH)/bin/python -m benchmarks.detector
	$(BENCH)/bin/python -m benchmarks.hold
	$(BENCH)/bin/python -m benchmarks.autopilot
	@test -z "$(PX4)" || PX4="$(PX4)" $(BENCH)/bin/python -m benchmarks.px4
	$(BENCH)/bin/python -m benchmarks.growth
	$(BENCH)/bin/python -m benchmarks.record
	-$(BENCH)/bin/python -m benchmarks.instructions
	-$(BENCH)/bin/python -m benchmarks.gpu
	$(BENCH)/bin/python -m benchmarks.runs --page docs/how-to/fly-many-runs.md

# The same numbers by Boresight, by peers and in 50 digits; results and docs/cross-checks.md.  Never in CI.
cross-checks: $(BENCH)/.installed
	$(BENCH)/bin/python -m boresight.evidence.crossed

# The site of the documentation, into out/site, without a network once its environment is there.
site: $(SITE)/.installed
	$(SITE)/bin/python -m docs.site.build -o out/site

tools:
	@command -v $(PYTHON) >/dev/null || { echo "make: $(PYTHON) is missing; install python3 (3.11 or newer)"; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "make: $(PYTHON) is older than 3.11; set PYTHON to a newer one"; exit 1; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || { echo "make: the venv module is missing; install python3-venv"; exit 1; }
	@command -v $${CC:-cc} >/dev/null || { echo "make: no C compiler; install gcc, or set CC"; exit 1; }

$(VENV)/.installed: pyproject.toml constraints.txt | tools
	@$(PYTHON) -m venv $(VENV)
	@$(BIN)/pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[$(EXTRAS)]'
	@touch $@

$(VENV)/.tested: $(VENV)/.installed
	$(BIN)/pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[test]'
	touch $@

# One peer after another: what does not install is left out, and the table says so.
$(BENCH)/.installed: pyproject.toml benchmarks/constraints.txt | tools
	@$(PYTHON) -m venv $(BENCH)
	@$(BENCH)/bin/pip install --quiet --disable-pip-version-check -c benchmarks/constraints.txt -e '.[derive,replay]'
	@for peer in $(PEERS) $(COUNTING); do \
		$(BENCH)/bin/pip install --quiet --disable-pip-version-check -c benchmarks/constraints.txt $$peer \
			|| echo "make: $$peer does not install"; \
	done
	@test -e /usr/include/eigen3 || { mkdir -p $(BENCH)/debian && cd $(BENCH)/debian \
		&& apt-get -qq -o APT::Sandbox::User=root download libeigen3-dev && dpkg -x libeigen3-dev_*.deb .; } \
		|| echo "make: there is no libeigen3-dev"
	@touch $@

$(SITE)/.installed: pyproject.toml constraints.txt | tools
	@$(PYTHON) -m venv $(SITE)
	@$(SITE)/bin/pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[all,site]'
	@touch $@

clean:
	rm -rf $(VENV) $(BENCH) $(SITE) out build dist *.egg-info
