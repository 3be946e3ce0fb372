(* Numbers, JSON and expressions as text.
   SPDX-License-Identifier: GPL-3.0-or-later *)
open Fraction

let unread what = raise (Unread what)
let is_digit c = c >= '0' && c <= '9'
let digits s = s <> "" && String.for_all is_digit s

(* [-+] digits [. digits] [e [+-] digits], or a ratio of integers. *)
let number text =
  let fail () = unread ("'" ^ text ^ "' is not a number") in
  let sign, body =
    match text with
    | "" -> fail ()
    | _ when text.[0] = '-' -> (Q.minus_one, String.sub text 1 (String.length text - 1))
    | _ when text.[0] = '+' -> (Q.one, String.sub text 1 (String.length text - 1))
    | _ -> (Q.one, text)
  in
  let split c s = match String.index_opt s c with
    | None -> (s, None)
    | Some k -> (String.sub s 0 k, Some (String.sub s (k + 1) (String.length s - k - 1))) in
  match split '/' body with
  | p, Some q when digits p && digits q && Z.sign (Z.of_string q) > 0 ->
      Q.mul sign (Q.make (Z.of_string p) (Z.of_string q))
  | _, Some _ -> fail ()
  | _, None ->
      let mantissa, exponent = split 'e' (String.lowercase_ascii body) in
      let whole, part = split '.' mantissa in
      let part = Option.value part ~default:"" in
      if not (digits (whole ^ part)) then fail ();
      let power =
        match exponent with
        | None -> 0
        | Some e ->
            let unsigned = match e with
              | "" -> fail ()
              | _ when e.[0] = '-' || e.[0] = '+' -> String.sub e 1 (String.length e - 1)
              | _ -> e in
            if (not (digits unsigned)) || String.length unsigned > 5 then fail ();
            (if e.[0] = '-' then -1 else 1) * int_of_string unsigned
      in
      let power = power - String.length part in
      let ten = Q.of_bigint (Z.pow (Z.of_int 10) (abs power)) in
      let n = Q.of_bigint (Z.of_string (whole ^ part)) in
      Q.mul sign (if power >= 0 then Q.mul n ten else Q.div n ten)

(* ---------------------------------------------------------------- expressions *)
(* A sum of terms, products of signed powers; an atom is a number, t, s or a sum in brackets. Without s neither t nor s is read. *)
let expression ?s text =
  let at = ref 0 and n = String.length text in
  let fail () = unread (Printf.sprintf "'%s' is no expression at character %d" text (!at + 1)) in
  let char k = if k < n then text.[k] else '\000' in
  let rec peek () =
    if !at < n && String.contains " \t\r\n" text.[!at] then (incr at; peek ()) else char !at in
  let take c = peek () = c && !at < n && (incr at; true) in
  let rec digits_from k = if is_digit (char k) then digits_from (k + 1) else k in
  let literal () =
    let k = digits_from !at in
    let k = if char k = '.' then digits_from (k + 1) else k in
    let k = if char k = 'e' || char k = 'E'
      then digits_from (if char (k + 1) = '+' || char (k + 1) = '-' then k + 2 else k + 1) else k in
    let out = String.sub text !at (k - !at) in
    if out = "" then fail ();
    at := k;
    constant (number out) in
  let rec sum () =
    let rec more f =
      if take '+' then more (f +: term ()) else if take '-' then more (f -: term ()) else f in
    more (term ())
  and term () =
    let rec more f =
      if take '*' then more (f *: signed ()) else if take '/' then more (f /: signed ()) else f in
    more (signed ())
  and signed () =
    if take '-' then zero -: signed () else if take '+' then signed () else power ()
  and power () =
    let f = atom () in
    if not (take '^') then f
    else begin
      let negative = take '-' in
      if not negative then ignore (take '+');
      ignore (peek ());
      let k = digits_from !at in
      if k = !at then fail ();
      let e = number (String.sub text !at (k - !at)) in
      if Q.gt e (Q.of_int 300) then unread "an exponent above 300";
      at := k;
      let rec raised k = if k = 0 then one else if negative then raised (k - 1) /: f else raised (k - 1) *: f in
      let out = raised (Z.to_int (Q.num e)) in
      if peek () = '^' then fail ();
      out
    end
  and atom () =
    if take '(' then begin
      let f = sum () in
      if not (take ')') then fail ();
      f
    end else
      match s with
      | Some _ when take 't' -> t
      | Some s when take 's' -> s
      | _ -> ignore (peek ()); literal () in
  let out = sum () in
  ignore (peek ());
  if !at < n then fail ();
  out

(* ---------------------------------------------------------------- JSON *)
type json = Text of string | Number of string | List of json list | Object of (string * json) list

let json text =
  let at = ref 0 and n = String.length text in
  let fail what = unread (Printf.sprintf "JSON, character %d: %s is expected" (!at + 1) what) in
  let rec peek () =
    if !at < n && String.contains " \t\r\n" text.[!at] then (incr at; peek ())
    else if !at < n then text.[!at] else '\000' in
  let expect c = if peek () <> c then fail (Printf.sprintf "'%c'" c); incr at in
  let string () =
    expect '"';
    let first = !at in
    while !at < n && text.[!at] <> '"' do
      if text.[!at] = '\\' || text.[!at] < ' ' then fail "plain text";
      incr at
    done;
    expect '"';
    String.sub text first (!at - 1 - first) in
  let several close item =
    incr at;
    if peek () = close then (incr at; [])
    else
      let rec more () =
        let x = item () in
        if peek () = ',' then (incr at; x :: more ()) else (expect close; [ x ]) in
      more () in
  let rec value () =
    match peek () with
    | '"' -> Text (string ())
    | '[' -> List (several ']' value)
    | '{' ->
        let pairs = several '}' (fun () -> let key = string () in expect ':'; (key, value ())) in
        let keys = List.map fst pairs in
        if List.length (List.sort_uniq compare keys) <> List.length keys then fail "each key once";
        Object pairs
    | c when c = '-' || is_digit c ->
        let first = !at in
        while !at < n && String.contains "+-.eE0123456789" text.[!at] do incr at done;
        Number (String.sub text first (!at - first))
    | _ -> fail "a value" in
  let out = value () in
  if peek () <> '\000' || !at < n then fail "the end";
  out

let member key = function Object pairs -> List.assoc_opt key pairs | _ -> None
let wanted key where = match member key where with Some x -> x | None -> unread ("key '" ^ key ^ "' is expected")
let items = function List l -> l | _ -> unread "an array is expected"
let entry ?s = function Text e | Number e -> expression ?s e | _ -> unread "an expression is expected"
let constant_entry where =
  match value (entry where) with Some q -> q | None -> unread "a number is expected"
