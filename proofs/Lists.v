(* When two lists are equal, and when a list has no element twice. Paper.v, Period.v and
   Certificate.v use these lemmas; no Haskell module relies on them directly. *)
From Coq Require Import NArith List Bool Lia.
From PraTactile Require Import Exec Grid Checker.
Import ListNotations.
Local Open Scope N_scope.

Lemma same_eq a b : same a b = true -> a = b.
Proof.
  revert b; induction a as [| x a IH]; intros [| y b]; simpl; try easy.
  rewrite andb_true_iff, N.eqb_eq; intros [-> E]; f_equal; auto.
Qed.
Lemma same_refl a : same a a = true.
Proof. induction a as [| x a IH]; simpl; [easy |]; now rewrite N.eqb_refl. Qed.
Lemma sameRows_eq a b : sameRows a b = true -> a = b.
Proof.
  revert b; induction a as [| x a IH]; intros [| y b]; simpl; try easy.
  rewrite andb_true_iff; intros [S E]; f_equal; [now apply same_eq | auto].
Qed.

(* If the number of different elements is the length, no element comes twice. *)
Lemma different_le contents : different contents <= N.of_nat (length contents).
Proof.
  induction contents as [| a others IH]; simpl different; simpl length; [easy |].
  rewrite Nnat.Nat2N.inj_succ.
  destruct existsb; [rewrite N.add_0_l; apply N.le_le_succ_r, IH |].
  rewrite N.add_1_l; apply -> N.succ_le_mono; exact IH.
Qed.

Lemma different_NoDup contents : different contents = N.of_nat (length contents) -> NoDup contents.
Proof.
  induction contents as [| a others IH]; simpl different; simpl length; [constructor |].
  rewrite Nnat.Nat2N.inj_succ; pose proof (different_le others) as L.
  destruct existsb eqn:E; intros H.
  - rewrite N.add_0_l in H; rewrite H in L; destruct (N.nle_succ_diag_l _ L).
  - rewrite N.add_1_l in H; apply N.succ_inj in H; constructor; [| exact (IH H)].
    intros I; assert (existsb (same a) others = true) as E'; [| congruence].
    apply existsb_exists; exists a; split; [exact I | apply same_refl].
Qed.

Lemma NoDup_image {A B} (f : A -> B) l : NoDup l -> (forall x y, In x l -> In y l -> f x = f y -> x = y) ->
  NoDup (map f l).
Proof.
  induction 1 as [| x l N D IH]; intros I; simpl; constructor.
  - intros J; apply in_map_iff in J as (y & E & J).
    assert (y = x) as -> by (apply I; simpl; auto); easy.
  - apply IH; intros; apply I; simpl; auto.
Qed.
Lemma NoDup_upTo n : NoDup (upTo n).
Proof. apply NoDup_image; [apply seq_NoDup |]; intros; lia. Qed.

(* The values of f on a list without repetition do not repeat, if f takes no value twice. *)
Lemma parts_distinct {A B} (f : A -> option B) l : NoDup l ->
  (forall a b w, In a l -> In b l -> f a = Some w -> f b = Some w -> a = b) ->
  NoDup (map snd (flat_map (fun a => match f a with Some w => [(a, w)] | None => [] end) l)).
Proof.
  induction 1 as [| a l N D IH]; intros I; simpl; [constructor |].
  rewrite map_app; destruct (f a) as [w |] eqn:E; simpl; [| apply IH; intros; eapply I; simpl; eauto].
  constructor; [| apply IH; intros; eapply I; simpl; eauto].
  intros J; apply in_map_iff in J as ([b w'] & E' & J); simpl in E'; subst w'.
  apply in_flat_map in J as (c & J & F); destruct (f c) as [w' |] eqn:G; [| easy].
  destruct F as [[= -> ->] | []]; apply N; rewrite (I a b w); simpl; auto.
Qed.
