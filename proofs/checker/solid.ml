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

let normal corners =
  let a = Array.of_list corners in
  let n = Array.length a in
  let term i k =
    let p = a.(k) and q = a.((k + 1) mod n) in
    Z.sub (Z.mul (at p (i + 1)) (at q (i + 2))) (Z.mul (at p (i + 2)) (at q (i + 1))) in
  List.init 3 (fun i -> List.fold_left Z.add Z.zero (List.init n (term i)))

let rec ears axis sign corners =
  match corners with
  | [ p; q; r ] -> [ [ p; q; r ] ]
  | _ ->
      let a = Array.of_list corners in
      let n = Array.length a in
      let corner k = a.((k + n) mod n) in
      let turn p q r = sign * Z.sign (cross p q r axis) in
      let ear k =
        let p = corner (k - 1) and q = corner k and r = corner (k + 1) in
        turn p q r > 0
        && List.for_all
             (fun i -> let x = corner (k + i) in not (turn p q x >= 0 && turn q r x >= 0 && turn r p x >= 0))
             (List.init (max 0 (n - 3)) (fun i -> i + 2)) in
      let rec first k = if k = n then unread "a facet cannot be cut into triangles ear by ear" else if ear k then k else first (k + 1) in
      let k = first 0 in
      [ corner (k - 1); corner k; corner (k + 1) ] :: ears axis sign (List.filteri (fun i _ -> i <> k) corners)

let fan = function
  | p :: rest ->
      let rec go = function q :: (r :: _ as more) -> [ p; q; r ] :: go more | _ -> [] in
      go rest
  | [] -> []

let facet triangulate corners =
  let n = List.length corners in
  let before k = List.nth corners ((k + n - 1) mod n) in
  let corners = if n > 3 then List.filteri (fun k v -> v <> before k) corners else corners in
  if List.length corners < 3 then raise (Refuted "solid: a facet has no area");
  if List.length corners = 3 then [ corners ]
  else begin
    let m = normal corners in
    let dot v = List.fold_left2 (fun s a b -> Z.add s (Z.mul a b)) Z.zero m v in
    let axis = match List.find_opt (fun i -> Z.sign (List.nth m i) <> 0) [ 0; 1; 2 ] with
      | Some i -> i | None -> raise (Refuted "solid: a facet has no area") in
    if List.for_all (fun v -> Z.equal (dot v) (dot (List.hd corners))) corners then
      ears axis (Z.sign (List.nth m axis)) corners
    else if triangulate then fan corners
    else raise (Refuted "solid: a facet is not planar")
  end

(* ---------------------------------------------------------------- files *)
let off triangulate text =
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
        let colours = List.length rest - n in
        if n < 3 || not (List.mem colours [ 0; 1; 3; 4 ]) then unread "a facet is corners and a colour";
        List.iteri (fun i w -> if i >= n then ignore (number w)) rest;
        List.filteri (fun i _ -> i < n) rest
        |> List.map (fun w ->
               let v = count "a corner" w in
               if v >= vertices then unread "a corner is the number of a vertex";
               positions.(v))
    | [] -> unread "a facet is expected" in
  (3, scale, List.concat (List.init facets (fun k -> facet triangulate (corners k))))

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

let read path triangulate text =
  let text = if String.length text >= 3 && String.sub text 0 3 = "\xEF\xBB\xBF"
    then String.sub text 3 (String.length text - 3) else text in
  match Filename.extension path with
  | ".off" -> off triangulate text
  | ".wkt" -> wkt text
  | _ -> unread "a solid in .off or .wkt is expected"
