\\ The word of one trajectory against the boundary of a solid, for recompute.py. All exact.
\\
\\ A time is [lo, hi, p]: the one root in (lo, hi) of p, irreducible over Q of degree 2 or more; or
\\ [r, r, 0], the rational r. Irreducible factors make equal times equal and different ones differ.
\\ A facet is [n, d, k, V, j, I]: the plane n.x = d, two coordinates k that do not see it edge-on,
\\ its corners V in turn, its number j and its corners' numbers I; where d = 2 an edge, k empty. A
\\ contact is a root of a plane's polynomial at which the point lies in the closed facet, or a gap
\\ in which it stays in one. A cell is [0, face], [1, vertex, vertex] or [2, vertex].
\\ SPDX-License-Identifier: GPL-3.0-or-later

refine(T) = { my([lo, hi, p] = T, m = (lo + hi) / 2);
  if(sign(subst(p, 't, m)) == sign(subst(p, 't, lo)), [m, hi, p], [lo, m, p]); }

\\ The roots of an irreducible polynomial in [a, b], no end of an interval being one.
isolate(p, a, b) = { my(n = polsturm(p, [a, b]), T, m = (a + b) / 2);
  if(n == 0, return([]));
  if(n > 1, return(concat(isolate(p, a, m), isolate(p, m, b))));
  T = [a, b, p]; while(T[2] - T[1] > 2^-10, T = refine(T)); [T]; }

{cache = Map();}
factor_roots(p, a, b) = { my(out = 0, r, key);
  if(poldegree(p) == 1, r = -polcoef(p, 0) / polcoef(p, 1);
    return(if(a <= r && r <= b, [[r, r, 0]], [])));
  p = p / content(p) * sign(pollead(p)); key = [p, a, b];
  if(mapisdefined(cache, key, &out), return(out));
  out = isolate(p, a, b); mapput(cache, key, out); out; }

roots_in(f, a, b) = {
  if(poldegree(f) <= 0 || polsturm(f, [a, b]) == 0, return([]));
  my(out = []); foreach(factor(f)[, 1], p, out = concat(out, factor_roots(p, a, b))); out; }

\\ The sign of f, a polynomial or a number, at the time T.
sign_at(f, T) = {
  if(poldegree(f) <= 0, return(sign(simplify(f))));
  if(T[3] == 0, return(sign(subst(f, 't, T[1]))));
  if(poldegree(f) >= poldegree(T[3]) && f % T[3] == 0, return(0));
  while(polsturm(f, [T[1], T[2]]), T = refine(T));
  sign(subst(f, 't, T[1])); }

\\ Where N/D at the time T, known to lie in the facet's plane, is: 1 in its interior, 2 on its rim,
\\ 0 elsewhere. The rim is crossed by a ray in the plane.
place(F, N, D, T) = {
  my(k = F[3], V = F[4], odd = 0, m = #V);
  if(k == [], return(if(between_ends(V[1], V[2], N, D, T), 1, 0)));
  my(i = k[1], j = k[2]);
  my(low = vecmin([v[j] | v <- V]), high = vecmax([v[j] | v <- V]));
  if(sign_at(N[j] - low * D, T) < 0 || sign_at(N[j] - high * D, T) > 0, return(0));
  my(S = [sign_at(N[j] - v[j] * D, T) | v <- V]);
  for(e = 1, m, my(g = if(e < m, e + 1, 1), u = V[e], v = V[g], o);
    if(S[e] * S[g] > 0, next);
    o = sign_at((v[i] - u[i]) * (N[j] - u[j] * D) - (v[j] - u[j]) * (N[i] - u[i] * D), T);
    if(o == 0 && between_ends(u, v, N, D, T), return(2));
    if((S[e] >= 0) != (S[g] >= 0) && o == if(S[e] < 0, -1, 1), odd = 1 - odd));
  odd; }
between_ends(u, v, N, D, T) = {
  for(k = 1, #u, if(sign_at(N[k] - u[k] * D, T) * sign_at(N[k] - v[k] * D, T) > 0, return(0))); 1; }

\\ The state of a rational point: B on a facet; else the parity of a slanted ray's facets, the ray
\\ being changed where it meets a rim.
state(X, facets) = {
  my(Z = [0, 0, 0], rays);
  rays = [[1009, 337, 211], [-613, 1201, 89], [227, -401, 1303], [-71, -1511, -2003]];
  for(f = 1, #facets, my(F = facets[f]); if(F[1] * X~ == F[2] && place(F, X, 1, Z), return("B")));
  for(r = 1, #rays, my(w = rays[r][1..#X], odd = 0, good = 1);
    for(f = 1, #facets, my(F = facets[f], s = F[1] * w~, l, p, Y);
      if(F[1] * F[1]~ == 0, next); \\ a side without length
      if(s == 0, if(F[1] * X~ == F[2], good = 0; break, next));
      l = (F[2] - F[1] * X~) / s; if(l < 0, next);
      Y = X + l * w; p = place(F, Y, 1, Z);
      if(p == 2 || (p && #X == 2 && (Y == F[4][1] || Y == F[4][2])), good = 0; break);
      odd = bitxor(odd, p));
    if(good, return(if(odd, "I", "O"))));
  error("every ray meets a rim"); }

\\ The times at which N/D has a coordinate of the corner u.
at_corner(u, N, D, a, b) = concat(vector(#u, k, roots_in(N[k] - u[k] * D, a, b)));

\\ The times at which a point that moves in the facet's plane can enter or leave it.
rim_times(F, N, D, a, b) = {
  my(V = F[4], out = [], i, j);
  if(F[3] == [], return(concat(at_corner(V[1], N, D, a, b), at_corner(V[2], N, D, a, b))));
  [i, j] = F[3];
  for(e = 1, #V, my(u = V[e], v = V[e % #V + 1], g);
    g = (v[i] - u[i]) * (N[j] - u[j] * D) - (v[j] - u[j]) * (N[i] - u[i] * D);
    out = concat(out, if(g == 0,
      concat(at_corner(u, N, D, a, b), at_corner(v, N, D, a, b)), roots_in(g, a, b))));
  out; }

\\ Times in order, their intervals made disjoint.
in_order(L) = { my(again = 1, before = (x, y) -> sign(if(x[1] == y[1], x[2] - y[2], x[1] - y[1])));
  L = Set(L);
  while(again, again = 0; L = vecsort(L, before);
    for(k = 1, #L - 1, if(L[k][2] >= L[k+1][1],
      again = 1; for(q = k, k + 1, if(L[q][3] != 0, L[q] = refine(L[q]))))));
  L; }

\\ The cells of facet F in whose relative interior N/D, known to lie in the closed facet, is.
rim_cells(F, N, D, T) = {
  my(V = F[4], I = F[6], m = #V, out = []);
  my(at(u) = vecmin([sign_at(N[k] - u[k] * D, T) == 0 | k <- [1..#u]]));
  for(e = 1, if(m == 2, 1, m), my(g = e % m + 1, u = V[e], v = V[g]);
    if(at(u), out = concat(out, [[2, I[e]]]); next);
    if(at(v), out = concat(out, [[2, I[g]]]); next);
    if(on_line(F, u, v, N, D, T) && between_ends(u, v, N, D, T),
      out = concat(out, [[1, min(I[e], I[g]), max(I[e], I[g])]])));
  out; }
on_line(F, u, v, N, D, T) = {
  if(F[3] == [], return(1));
  my([i, j] = F[3]);
  sign_at((v[i] - u[i]) * (N[j] - u[j] * D) - (v[j] - u[j]) * (N[i] - u[i] * D), T) == 0; }

\\ All cells N/D is on at the time T; none off the boundary.
cells(facets, N, D, T) = {
  my(out = []);
  foreach(facets, F, if(sign_at(F[1] * N~ - F[2] * D, T) == 0,
    my(p = place(F, N, D, T));
    if(p, out = concat(out, if(p == 1 && F[3] != [], [[0, F[5]]], rim_cells(F, N, D, T))))));
  Set(out); }

\\ One piece: [time, state, its cells, state of the gap after it, its cells]; after the last no gap.
piece_trace(c, a, b, facets) = {
  my(D = 1, N, met = [[a, a, 0], [b, b, 0]], more = [], out = [], T);
  for(k = 1, #c, D = lcm(D, denominator(c[k])));
  if(subst(D, 't, (a + b) / 2) < 0, D = -D);
  N = [simplify(x * D) | x <- c]; cache = Map();
  foreach(facets, F, my(f = F[1] * N~ - F[2] * D);
    if(f == 0, more = concat(more, rim_times(F, N, D, a, b)),
      more = concat(more, [T | T <- roots_in(f, a, b), place(F, N, D, T)])));
  T = in_order(concat(met, more));
  for(k = 1, #T,
    my(on = cells(facets, N, D, T[k]), gap = "", under = []);
    if(k < #T, my(r = (T[k][2] + T[k+1][1]) / 2, Z = [r, r, 0]);
      gap = state([subst(x, 't, r) | x <- c], facets);
      if(gap == "B", under = cells(facets, N, D, Z)));
    out = concat(out, [[T[k], if(#on, "B", "?"), on, gap, under]]));
  for(k = 1, #out, if(out[k][2] == "?",
    out[k][2] = if(k < #out, out[k][4], out[k-1][4]);
    if(out[k][2] == "B" || (k > 1 && out[k-1][4] != out[k][2]),
      error("the states around a time do not fit"))));
  out; }

\\ All pieces as one list of [state, time, cells], the time of a gap being "gap".
follow(motion, P, facets) = {
  my(all = []);
  foreach(motion, p, my(c = p[3] * concat(P, [1])~, E = piece_trace(c[1..#P]~, p[1], p[2], facets));
    foreach(E, e, my(n = #all);
      if(n && all[n][2] == e[1] && all[n][1] != e[2], error("the pieces do not join"));
      all = concat(all, [[e[2], e[1], e[3]]]);
      if(e[4] != "", all = concat(all, [[e[4], "gap", e[5]]]))));
  all; }

time_text(T) = if(T[3] == 0, T[1], Str(Vecrev(T[3]), "@", T[1], "@", T[2]));

cell_text(c) = {
  if(c[1] == 1, Str("edge ", c[2], "-", c[3]), Str(if(c[1], "vertex ", "face "), c[2])); }

\\ "answer ID WORD|FROM|TO|CELLS|FROM|TO|CELLS ..."
answer(id, motion, P, facets) = {
  my(all = follow(motion, P, facets), word = "", out = "", k = 1);
  while(k <= #all, my(q = k, met = []);
    while(q < #all && all[q+1][1] == all[k][1], q++);
    word = Str(word, all[k][1]);
    if(all[k][1] == "B",
      for(e = k, q, met = concat(met, all[e][3]));
      out = Str(out, "|", time_text(all[k][2]), "|", time_text(all[q][2]), "|");
      foreach(vecsort(Set(met)), c, out = Str(out, cell_text(c), " ")));
    k = q + 1);
  print("answer ", id, " ", word, out); }
