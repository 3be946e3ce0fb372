(* Zarith's integers under a name that the extracted modules do not take.
   SPDX-License-Identifier: GPL-3.0-or-later *)
include Z
