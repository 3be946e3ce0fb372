(* Numbers, entries of motions, and JSON as text.
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

(* A sum of terms c t^k, or (a sum)/(a sum): proofs/certificate.md, section 2. *)
let expression text =
  let at = ref 0 and n = String.length text in
  let fail () = unread (Printf.sprintf "'%s' is neither A nor (A)/(A) at character %d" text (!at + 1)) in
  let rec blanks () = if !at < n && text.[!at] = ' ' then (incr at; blanks ()) in
  let take c = blanks (); !at < n && text.[!at] = c && (incr at; true) in
  let cut goes_on =
    let first = !at in
    while !at < n && goes_on text.[!at] do incr at done;
    String.sub text first (!at - first) in
  let power () =
    if not (take '^') then 1
    else begin
      blanks ();
      let k = cut is_digit in
      if k = "" || String.length k > 9 then fail ();
      if int_of_string k > 300 then unread "a polynomial of degree above 300";
      int_of_string k
    end in
  let term () =
    blanks ();
    let w = cut (fun c -> not (String.contains "* )t" c)) in
    let c = if w = "" then Q.one else number w in
    if w <> "" && not (take '*') then monomial c 0
    else if take 't' then monomial c (power ())
    else fail () in
  let rec sum f minus =
    let g = term () in
    let f = if minus then f -: g else f +: g in
    if take '-' then sum f true else if take '+' then sum f false else f in
  let polynomial () = sum zero (take '-') in
  let out =
    if not (take '(') then polynomial ()
    else begin
      let top = polynomial () in
      if not (take ')' && take '/' && take '(') then fail ();
      let bottom = polynomial () in
      if not (take ')') then fail ();
      top /: bottom
    end in
  blanks ();
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

let items = function List l -> l | _ -> unread "an array is expected"
let content = function Text w | Number w -> w | _ -> unread "a number or an entry is expected"
let entry where = expression (content where)
