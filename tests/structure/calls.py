# SPDX-License-Identifier: GPL-3.0-or-later
"""The call graph between files, from the symbols of their objects.

A file calls another where its object has an undefined symbol that the other's object defines. That counts every
use of a function's name: a call, also from a static function, which belongs to the file that holds it, and the
taking of its address. A call through a pointer (a callback, the comparison of a sort, the hand-over of a destructor)
is an arrow from the file that names the function, never from the one that calls it: the latter does not know it.
Inline functions of headers and C++ templates belong to the file that includes them; weak symbols are theirs and
belong to no file.
"""
import collections
import os
import subprocess

Object = collections.namedtuple("Object", "functions data used")


def object_of(build, source):
    return os.path.join(build, os.path.splitext(source)[0] + ".o")


def read_objects(build, files):
    """{source: Object} of those whose object is there."""
    there = {object_of(build, source): source for source in files if os.path.exists(object_of(build, source))}
    listing = subprocess.run(["nm", "--format=posix", "--print-file-name", *there], stdout=subprocess.PIPE, check=True).stdout.decode()
    symbols = collections.defaultdict(list)
    for line in listing.splitlines():
        path, _, row = line.partition(": ")
        symbols[path].append(row.split()[:2])
    return {source: Object(*({name for name, kind in symbols[path] if kind in kinds} for kinds in ("T", "DBRC", "U")))
            for path, source in there.items()}


def free_functions(names):
    """Names of functions as written; members of classes are left out, whose declaration is that of the class."""
    done = subprocess.run(["c++filt"], input="\n".join(names).encode(), stdout=subprocess.PIPE, check=True)
    plain = {line.split("(")[0] for line in done.stdout.decode().splitlines()}
    return {name for name in plain if "::" not in name}


def holders(objects):
    """{symbol: the sources that define it}. Of two, one is the other's stand-in in a second program."""
    found = collections.defaultdict(list)
    for source, symbols in objects.items():
        for name in symbols.functions | symbols.data:
            found[name].append(source)
    return found


def calls(objects, rank):
    """{(caller, callee): names}, to the lowest of several sources that define a symbol; rank(source) orders them."""
    found = holders(objects)
    arrows = collections.defaultdict(set)
    for source, symbols in objects.items():
        for name in symbols.used & found.keys():
            arrows[source, min(found[name], key=rank)].add(name)
    return arrows


def circles(arrows):
    """Sets of nodes that reach each other; arrows is a set of pairs. Tarjan's algorithm."""
    after = collections.defaultdict(list)
    for source, target in sorted(arrows):
        if source != target:
            after[source].append(target)
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for target in after[node]:
            if target not in index:
                visit(target)
            if target in low:
                low[node] = min(low[node], low[target])
        if low[node] == index[node]:
            component = set()
            while node not in component:
                member = stack.pop()
                del low[member]
                component.add(member)
            if len(component) > 1:
                found.append(component)

    for node in list(after):
        if node not in index:
            visit(node)
    return found
