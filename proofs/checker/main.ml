(* graze-check-coq SOLID MOTION CERTIFICATE: a certificate held to the verified checker, row by row.
   graze-check-coq --print SOLID MOTION: what the verified checker is given of them.
   SPDX-License-Identifier: GPL-3.0-or-later

   Exit status as graze-check's: 0 verified, 1 refuted, 2 not checked. The solid is assumed legal, and the result
   says so, unless the verified test of convex solids accepts it. *)
open Fraction
open Text

let refuted what = raise (Refuted what)
let read_file path =
  try
    let channel = open_in_bin path in
    let text = really_input_string channel (in_channel_length channel) in
    close_in channel;
    text
  with Sys_error e -> unread e

let time_of w = try Motion.time (number w) with Unread e -> refuted e
let integer_of w =
  let body = if w <> "" && w.[0] = '-' then String.sub w 1 (String.length w - 1) else w in
  if digits body then Z.of_string w else refuted "a coefficient is not an integer"
let count_of w = if digits w && String.length w <= 9 then int_of_string w else refuted ("'" ^ w ^ "' is not a count")

let state_of = function 'I' -> Checker.I | 'B' -> Checker.B | 'O' -> Checker.O | _ -> refuted "a letter is I, B or O"
let letters w = List.init (String.length w) (fun k -> state_of w.[k])

let kind_of w : Checker.kind =
  match letters w with
  | [ x ] -> Stays x
  | [ B; (I | O) as r ] -> Meets (None, Some r)
  | [ (I | O) as l; B ] -> Meets (Some l, None)
  | [ l; B; r ] -> Meets (Some l, Some r)
  | _ -> refuted ("an interval of kind '" ^ w ^ "'")

let interval line : (Checker.kind * (Z.t * Z.t)) * Z.t list =
  match line with
  | kind :: until :: q ->
      if (q <> []) <> (String.length kind = 3) then refuted "a kind of three letters has a polynomial, no other has";
      if List.length q > 301 then unread "a polynomial of degree above 300";
      ((kind_of kind, time_of until), List.map integer_of q)
  | _ -> refuted "an interval is a kind, a time and a polynomial"

let membership : string -> Checker.membership = function
  | "in" -> In_ | "on" -> On | "out" -> Out | w -> refuted ("'" ^ w ^ "' is no pmc")
let class_of : string -> Checker.class0 = function
  | "regular" -> Regular | "fold" -> Fold | "fold_boundary" -> Fold_boundary | "boundary" -> Boundary
  | "exterior" -> Exterior | w -> refuted ("'" ^ w ^ "' is no class")
let definition_of w = if w = "ext" then 0 else count_of w

(* A row's line; its intervals follow. *)
let row d unsweep line intervals =
  let point = List.filteri (fun k _ -> k < d) line and claims = List.filteri (fun k _ -> k >= d) line in
  if List.length point < d then refuted "a coordinate is missing";
  let p = List.map (fun w -> try number w with Unread e -> refuted e) point in
  let q = List.fold_left (fun z x -> Z.lcm z (Q.den x)) Z.one p in
  let v = q :: List.map (fun x -> Q.num (Q.mul (Q.of_bigint q) x)) p in
  let make word pmc c definition position i t k : Checker.row =
    { word_of = letters word; pmc = membership pmc; class_claimed = class_of c; definition = definition_of definition;
      position = count_of position; crosses = count_of i; tangent = count_of t; inner_count = count_of k; intervals } in
  match (claims, unsweep) with
  | [ word; pmc ], true -> (v, make word pmc "exterior" "0" "0" "0" "0" "0")
  | [ word; pmc; c; definition; position; i; t; k ], false -> (v, make word pmc c definition position i t k)
  | _ -> refuted "a row is a point, a word and what follows from it"

let rec take_intervals = function
  | (("row" | "complete") :: _) :: _ as rest -> ([], rest)
  | line :: rest -> let l, rest = take_intervals rest in (interval line :: l, rest)
  | [] -> refuted "the certificate ends without 'complete'"

let rec rows d unsweep number check = function
  | ("row" :: line) :: rest ->
      let intervals, rest = take_intervals rest in
      let v, r = row d unsweep line intervals in
      if not (check v r) then refuted (Printf.sprintf "row %d is not proved" number);
      rows d unsweep (number + 1) check rest
  | [ [ "complete"; n ] ] ->
      if count_of n = number then number
      else refuted (Printf.sprintf "'complete' says %d rows; the certificate has %d" (count_of n) number)
  | _ -> refuted "'row' or 'complete', the last line, is expected"

let sha256 path =
  let channel = Unix.open_process_args_in "sha256sum" [| "sha256sum"; "--"; path |] in
  let line = try input_line channel with End_of_file -> "" in
  ignore (Unix.close_process_in channel);
  if String.length line < 64 then unread "sha256sum does not answer";
  let from = if line.[0] = '\\' then 1 else 0 in
  String.sub line from 64

let held path hash = if sha256 path <> hash then refuted (path ^ ": its SHA-256 is not that of the certificate")
let choice what no yes w = if w = yes then true else if w = no then false else refuted (what ^ " is " ^ no ^ " or " ^ yes)

(* The test of a convex solid compares all its simplices with all. *)
let most_convex = 200

(* The number of rows, and whether the solid is proved legal. *)
let verify solid motion certificate =
  let lines = String.split_on_char '\n' (read_file certificate) in
  let lines = match List.rev lines with "" :: l -> List.rev l | _ -> refuted "the last line does not end" in
  match List.map Solid.words lines with
  | _ :: _ :: _ :: _ :: _ :: _ :: _ :: ("contacts" :: _) :: _ ->
      unread "the line 'contacts': this checker proves no times and cells"
  | [ "graze-certificate"; version ] :: [ "solid-sha256"; solid_hash ] :: [ "motion-sha256"; motion_hash ]
    :: [ "scene-sha256"; scene ] :: [ "dimension"; dimension ] :: [ "operation"; operation ] :: [ "folds"; folds ]
    :: ("signs" :: signs) :: rest ->
      if version <> "1" then unread "version 1 is expected";
      if String.length scene <> 64 then refuted "a SHA-256 has 64 digits";
      let three = choice "dimension" "2" "3" dimension in
      let unsweep = choice "operation" "sweep" "unsweep" operation in
      let folds : Checker.folds = if choice "folds" "separate" "combined" folds then Combined else Separate in
      held solid solid_hash;
      held motion motion_hash;
      let d, scale, simplices = Solid.read solid (read_file solid) in
      let dimension, pieces = Motion.read (json (read_file motion)) in
      if d <> dimension || d <> (if three then 3 else 2) then refuted "the dimensions differ";
      let pieces = List.map Motion.piece pieces in
      let facets = match Checker.facets_of scale d simplices with
        | Some f -> f | None -> refuted "solid: a simplex without area or length" in
      if not (Checker.check_motion d pieces (List.map time_of signs)) then refuted "motion: not proved legal";
      let operation : Checker.operation = if unsweep then Unsweeping else Sweeping in
      let number = rows d unsweep 0 (Checker.check_row operation folds d facets pieces) rest in
      (number, List.length simplices <= most_convex && Checker.convex_ok scale d simplices)
  | _ -> refuted "the certificate's head is not complete"

(* Simplices times `scale`; pieces: times, denominator, entry i j of the map, j = 0 its translation. *)
let print solid motion =
  let numbers l = String.concat " " (List.map Z.to_string l) in
  let d, scale, simplices = Solid.read solid (read_file solid) in
  let dimension, pieces = Motion.read (json (read_file motion)) in
  Printf.printf "dimensions %d %d\nscale %s\n" d dimension (Z.to_string scale);
  List.iter (fun s -> Printf.printf "simplex %s\n" (numbers (List.concat s))) simplices;
  let piece p =
    let q = Motion.piece p in
    Printf.printf "piece %s %s\nweight %s\n" (Q.to_string p.Motion.lo) (Q.to_string p.Motion.hi) (numbers q.forward_weight);
    List.iteri (fun i -> List.iteri (fun j e -> Printf.printf "entry %d %d %s\n" i j (numbers e))) q.forward in
  List.iter piece pieces

let guarded run =
  try run (); 0 with
  | Refuted what -> prerr_endline ("graze-check-coq: refuted: " ^ what); 1
  | Unread what -> prerr_endline ("graze-check-coq: not checked: " ^ what); 2
  | Stack_overflow | Out_of_memory -> prerr_endline "graze-check-coq: not checked: memory"; 2

let () =
  let status = match Sys.argv with
    | [| _; "--print"; solid; motion |] -> guarded (fun () -> print solid motion)
    | [| _; solid; motion; certificate |] ->
        guarded (fun () ->
            let number, legal = verify solid motion certificate in
            Printf.printf "verified%s: %d rows\n" (if legal then "" else ", assuming a legal solid") number)
    | _ -> prerr_endline "graze-check-coq SOLID MOTION CERTIFICATE are expected"; 2 in
  exit status
