\\ Motions as exact matrices over Q(t), for recompute.py.
\\ A motion is a vector of pieces [a, b, M], M a (d+1)x(d+1) matrix of rational functions of t that
\\ acts on columns (x, 1). SPDX-License-Identifier: GPL-3.0-or-later

affine(A, v) = matconcat([A, v~; matrix(1, #v), 1]);
about(A, c) = affine(A, c - (A * c~)~);
translate(v) = affine(matid(#v), v);
scale(e, c) = about(if(type(e) == "t_VEC", matdiagonal(e), e * matid(#c)), c);

\\ The matrix entry by entry, with or without its last row.
rows(R) = { my(d = #R[1] - 1);
  matrix(d + 1, d + 1, i, j, if(i <= d, R[i][j], i == j)); }

\\ The rotation of a quaternion that need not be a unit.
turned(q) = { my(w, x, y, z); [w, x, y, z] = q;
  [w^2+x^2-y^2-z^2, 2*(x*y-w*z), 2*(x*z+w*y);
   2*(x*y+w*z), w^2-x^2+y^2-z^2, 2*(y*z-w*x);
   2*(x*z-w*y), 2*(y*z+w*x), w^2-x^2-y^2+z^2] / (w^2+x^2+y^2+z^2); }
quaternion(q, c) = about(turned(q), c);

\\ The rotation by 2 atan(h): in the plane (axis 0), or about an axis whose length is rational and
\\ positive at the time m.
half(h, axis, m) = {
  my(e, L);
  if(axis == 0, return([1-h^2, -2*h; 2*h, 1-h^2] / (1+h^2)));
  e = axis * axis~;
  if(!issquare(e, &L), error("the axis has no rational length"));
  if(subst(L, 't, m) < 0, L = -L);
  turned(concat([L], h * axis)); }
rotate(h, n, axis, m, c) = about(half(h, axis, m)^n, c);

\\ What a turn of n quarters over [a, b] is on [u, v], which lies within one quarter.
turn(n, a, b, u, axis, c) = { my(g = sign(n), k, m);
  if(n == 0, return(about(matid(#c), c)));
  k = floor((u - a) / (b - a) * abs(n));
  m = abs(n) * ('t - a) / (b - a) - k;
  about(half(g, axis, u)^k * half(g * m, axis, u), c); }

compose(L) = { my(M = 1); for(k = 1, #L, M = L[k] * M); M; }

\\ Between frames [time, position, rotation] both run linearly; a rotation is a quaternion or, in
\\ the plane, a half angle as a complex number.
between(F, G) = {
  my(s = ('t - F[1]) / (G[1] - F[1]), x, y,
    p = F[2] + s * (G[2] - F[2]), q = F[3] + s * (G[3] - F[3]));
  if(#q == 4, return(affine(turned(q), p)));
  [x, y] = q;
  affine([x^2-y^2, -2*x*y; 2*x*y, x^2-y^2] / (x^2+y^2), p); }
keyframes(L) = vector(#L - 1, k, [L[k][1], L[k+1][1], between(L[k], L[k+1])]);

\\ The piece's matrix of a motion on an interval within it.
piece_at(A, u, v) = { for(k = 1, #A, if(A[k][1] <= u && v <= A[k][2], return(A[k][3])));
  error("an interval lies in no piece"); }
relative(A, B) = {
  my(cuts = vecsort(Set(concat([[p[1], p[2]] | p <- concat(A, B)]))));
  vector(#cuts - 1, k, my(u = cuts[k], v = cuts[k+1]);
    [u, v, piece_at(B, u, v)^-1 * piece_at(A, u, v)]); }
sequence(L) = {
  my(out = [], E = 1);
  for(j = 1, #L, my(A = L[j], a = A[1][1], b = A[#A][2], w = b - a, f(x) = (x - a) / w + j - 1);
    for(k = 1, #A, my(S = subst(A[k][3], 't, a + w * ('t - j + 1)));
      out = concat(out, [[f(A[k][1]), f(A[k][2]), S * E]]));
    E = subst(A[#A][3], 't, b) * E);
  out; }
