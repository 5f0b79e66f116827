"""``python -m macram.cli``, where the command's script is not on PATH."""

import sys

from macram.cli.app import main

sys.exit(main())
