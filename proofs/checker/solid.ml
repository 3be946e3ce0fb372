(* Solids, .off and .wkt, cut into oriented simplices (proofs/certificate.md, section 2).
   SPDX-License-Identifier: GPL-3.0-or-later *)
open Fraction
open Text

let words s = List.filter (( <> ) "") (String.split_on_char ' ' (String.map (fun c -> if c = '\t' then ' ' else c) s))
let count what w = if digits w && String.length w <= 9 then int_of_string w else unread (what ^ " is expected")

(* Coordinates times one integer. *)
let integers points =
  let scale = List.fold_left (List.fold_left (fun z q -> Z.lcm z (Q.den q))) Z.one points in
  (scale, List.map (List.map (fun q -> Q.num (Q.mul (Q.of_bigint scale) q))) points)

(* ---------------------------------------------------------------- cutting facets *)
let at v i = List.nth v (i mod 3)
let cross p q r i =
  let u k = Z.sub (at q k) (at p k) and v k = Z.sub (at r k) (at p k) in
  Z.sub (Z.mul (u (i + 1)) (v (i + 2))) (Z.mul (u (i + 2)) (v (i + 1)))

let fan = function
  | p :: rest ->
      let rec go = function q :: (r :: _ as more) -> [ p; q; r ] :: go more | _ -> [] in
      go rest
  | [] -> []

(* The fan of the first corner, whose pieces have area and turn one way. *)
let facet corners =
  let pieces = fan corners in
  let area = function [ p; q; r ] -> List.init 3 (cross p q r) | _ -> [] in
  let dot u v = List.fold_left2 (fun s a b -> Z.add s (Z.mul a b)) Z.zero u v in
  let m = area (List.hd pieces) in
  if List.exists (fun v -> not (Z.equal (dot m v) (dot m (List.hd corners)))) corners then
    raise (Refuted "solid: a facet is not planar");
  if List.exists (fun t -> Z.sign (dot m (area t)) <= 0) pieces then
    unread "a facet has no area, or is not the fan of its first corner";
  pieces

(* ---------------------------------------------------------------- files *)
let off text =
  let without_comment l = match String.index_opt l '#' with Some k -> String.sub l 0 k | None -> l in
  let clean l = words (String.map (fun c -> if c = '\r' then ' ' else c) (without_comment l)) in
  let lines = List.filter (( <> ) []) (List.map clean (String.split_on_char '\n' text)) in
  let rec counts found lines = match (found, lines) with
    | [ c; b; a ], rest -> (count "a count" a, count "a count" b, c, rest)
    | _, (w :: more) :: rest -> counts (w :: found) (if more = [] then rest else more :: rest)
    | _, [] :: rest -> counts found rest
    | _, [] -> unread "three counts are expected" in
  let lines = match lines with
    | [ "OFF" ] :: rest -> rest
    | ("OFF" :: more) :: rest -> more :: rest
    | _ -> unread "OFF is expected" in
  let vertices, facets, _, lines = counts [] lines in
  let lines = Array.of_list lines in
  if Array.length lines <> vertices + facets then unread "as many lines as vertices and facets are expected";
  let vertex k = match List.map number lines.(k) with [ x; y; z ] -> [ x; y; z ] | _ -> unread "a vertex has three numbers" in
  let scale, positions = integers (List.init vertices vertex) in
  let positions = Array.of_list positions in
  let corners k = match lines.(vertices + k) with
    | n :: rest ->
        let n = count "a number of corners" n in
        if n < 3 || List.length rest <> n then unread "a facet is its number of corners and as many vertices";
        List.map
          (fun w ->
            let v = count "a corner" w in
            if v >= vertices then unread "a corner is the number of a vertex";
            positions.(v))
          rest
    | [] -> unread "a facet is expected" in
  (3, scale, List.concat (List.init facets (fun k -> facet (corners k))))

let wkt text =
  let spaced = Buffer.create (2 * String.length text) in
  String.iter (fun c -> match c with
      | '(' | ')' | ',' -> Buffer.add_string spaced (Printf.sprintf " %c " c)
      | '\n' | '\r' -> Buffer.add_char spaced ' '
      | c -> Buffer.add_char spaced c) text;
  let rest = ref (words (Buffer.contents spaced)) in
  let next () = match !rest with w :: more -> rest := more; w | [] -> unread "the text ends early" in
  let want w = if next () <> w then unread ("'" ^ w ^ "' is expected") in
  let list item =
    want "(";
    let rec more () = let x = item () in
      match next () with "," -> x :: more () | ")" -> [ x ] | _ -> unread "',' or ')' is expected" in
    more () in
  let position () = let x = number (next ()) in let y = number (next ()) in [ x; y ] in
  let polygon () = list (fun () -> list position) in
  let polygons = match next () with
    | "POLYGON" -> [ polygon () ]
    | "MULTIPOLYGON" -> list polygon
    | _ -> unread "POLYGON or MULTIPOLYGON is expected" in
  if !rest <> [] then unread "text follows the last ')'";
  let rec sides = function a :: (b :: _ as more) -> (a, b) :: sides more | _ -> [] in
  let ring k l =
    if List.length l < 4 || List.hd l <> List.nth l (List.length l - 1) then
      unread "a ring has at least four positions, the last one its first";
    let area = List.fold_left (fun s (a, b) -> match (a, b) with
        | [ x; y ], [ u; v ] -> Q.add s (Q.sub (Q.mul x v) (Q.mul y u)) | _ -> s) Q.zero (sides l) in
    if Q.sign area = 0 then raise (Refuted "solid: a ring has no area");
    List.filter (fun (a, b) -> a <> b) (sides l)
    |> List.map (fun (a, b) -> if (Q.sign area > 0) = (k = 0) then [ a; b ] else [ b; a ]) in
  let all = List.concat (List.concat_map (List.mapi ring) polygons) in
  let scale, flat = integers (List.concat all) in
  let rec pairs = function a :: b :: more -> [ a; b ] :: pairs more | _ -> [] in
  (2, scale, pairs flat)

let read path text =
  let text = if String.length text >= 3 && String.sub text 0 3 = "\xEF\xBB\xBF"
    then String.sub text 3 (String.length text - 3) else text in
  match Filename.extension path with
  | ".off" -> off text
  | ".wkt" -> wkt text
  | _ -> unread "a solid in .off or .wkt is expected"
