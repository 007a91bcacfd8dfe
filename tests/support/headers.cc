// There are no sources: the target makes the precompiled headers of the tests.
