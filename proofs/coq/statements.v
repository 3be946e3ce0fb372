(* The main theorems: what each says, and on which axioms it rests.
   SPDX-License-Identifier: GPL-3.0-or-later

   What this file prints is compared with statements.txt. *)
Require Import Reals.
Require Import Graze.words Graze.counts Graze.definitions Graze.readings Graze.unsweep Graze.table.
Require Import Graze.times Graze.space Graze.sweep Graze.polynomials Graze.finite.

(* Words, counts and classes. *)
Check parity. Print Assumptions parity.
