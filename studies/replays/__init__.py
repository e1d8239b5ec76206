"""A filter flown on a recording: a module for each."""
