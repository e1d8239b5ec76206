"""What generate and verify say of the expressions of a model, without its C: the refusal, or each check, as JSON."""

import json
import sys

from boresight import BoresightError


def said(target):
    from boresight.codegen.functions.singular import refuse_singular
    from boresight.codegen.functions.units import units
    from boresight.codegen.generate import load_model
    from boresight.codegen.verify import laws, to_json

    model = load_model(target)
    made = units(model)
    refuse_singular(model, made)
    return to_json(laws(model, made))


if __name__ == "__main__":
    try:  # what is built in may be refused as it is imported
        print(json.dumps(said(sys.argv[1])))
    except BoresightError as error:
        print(json.dumps({"refused": str(error)}))
