"""What generate and verify say of the expressions of a model, without its C: the refusal, or each check, as JSON."""

import json
import sys

from boresight import BoresightError
from boresight.codegen.beside import check_beside
from boresight.codegen.flown import check_flown
from boresight.codegen.functions.singular import refuse_singular
from boresight.codegen.functions.units import units
from boresight.codegen.generate import load_model
from boresight.codegen.mechanics import check_mechanics
from boresight.codegen.unheld import with_unheld
from boresight.codegen.verify import to_json
from boresight.codegen.words import check_words


def laws(target):
    model = load_model(target)
    made = units(model)
    refuse_singular(model, made)
    references = {unit.name: unit.reference for unit in made}
    checks = check_mechanics(model, references) + check_flown(model, references)
    return with_unheld(model, [*checks, *check_beside(model), *check_words(model)])


if __name__ == "__main__":
    try:
        print(json.dumps(to_json(laws(sys.argv[1]))))
    except BoresightError as error:
        print(json.dumps({"refused": str(error)}))
