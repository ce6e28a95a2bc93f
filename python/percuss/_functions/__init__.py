# Made by python/scripts/make_functions.py from the declarations of the command line. Do not edit.
"""The functions of the package, a file for each."""
