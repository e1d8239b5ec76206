"""From functions to the text of C files: names, views for the templates, golden vectors, manifest.  Nothing is written
to disk here."""
