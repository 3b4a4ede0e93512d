-- | The kinds of mistakes that are planted, each as what stands at a site and what may stand there
-- instead.
module Kind
  ( Kind (..),
    Variant (..),
    Form (..),
    operators,
    functions,
    number,
    condition,
    exchanged,
    elements,
  )
where

-- | A kind of site. What is planted there is a function of this type, in whose variants @x@, @y@
-- and @f@ are its arguments.
data Kind = Kind
  { kindName :: String,
    kindType :: String,
    -- | Its arguments, as the planted function binds them.
    kindArguments :: String,
    -- | What stands there, over the arguments.
    kindOriginal :: String,
    -- | What may stand there instead.
    kindVariants :: [Variant],
    -- | The fixity that the planted function is declared with, if it is an operator.
    kindFixity :: Maybe String
  }

-- | A mistake at a site. Where it can be told at once that the value there is the same with it, no
-- test can notice it by this value. What tells it evaluates nothing that the original does not.
data Variant = Variant
  { variantName :: String,
    variantText :: String,
    -- | Whether the value is another one than the original's, as an expression over the arguments;
    -- true, too, where that could not be told.
    variantDiffers :: String
  }

always :: String
always = "Original.True"

-- | How a planted function takes the place of what stands at a site.
data Form
  = -- | It stands there instead: a name or an operator.
    Instead
  | -- | It is applied to what stands there.
    AppliedTo
  deriving stock (Eq, Show)

-- | Operators of the Prelude.
operators :: [(String, Kind)]
operators =
  [ (name, operator "comparison" compared "infix 4" name [(o, unlike name o) | o <- others])
    | (name, others) <-
        [("<", ["<=", ">="]), ("<=", ["<", ">"]), (">", [">=", "<="]), (">=", [">", "<"])]
  ]
    ++ [ ("==", operator "equality" equated "infix 4" "==" [("/=", always)]),
         ("/=", operator "equality" equated "infix 4" "/=" [("==", always)]),
         ("+", operator "addition" added "infixl 6" "+" [("-", always)]),
         ("-", operator "addition" added "infixl 6" "-" [("+", always)]),
         -- Whether the second one holds is known where the first one leaves it open.
         ("&&", operator "connective" joined "infixr 3" "&&" [("||", implied "Original.not y")]),
         ("||", operator "connective" joined "infixr 2" "||" [("&&", implied' "y")])
       ]
  where
    compared = "Original.Ord a => a -> a -> Original.Bool"
    equated = "Original.Eq a => a -> a -> Original.Bool"
    added = "Original.Num a => a -> a -> a"
    joined = "Original.Bool -> Original.Bool -> Original.Bool"
    unlike name other = unwords ["(x", original name, "y) Original./= (x", original other, "y)"]
    implied second = "if x then " ++ second ++ " else " ++ always
    implied' second = "if x then " ++ always ++ " else " ++ second

original :: String -> String
original = ("Original." ++)

operator :: String -> String -> String -> String -> [(String, String)] -> Kind
operator name signature fixity symbol others =
  Kind
    { kindName = name,
      kindType = signature,
      kindArguments = "x y",
      kindOriginal = applied symbol,
      kindVariants = [Variant other (applied other) differs | (other, differs) <- others],
      kindFixity = Just fixity
    }
  where
    applied one = unwords ["x", original one, "y"]

-- | Functions of base.
functions :: [(String, Kind)]
functions =
  [ ("not", function "negation" "Original.Bool -> Original.Bool" "x" "not x" negated),
    ("min", function "extreme" extremes "x y" "min x y" [other "max x y"]),
    ("max", function "extreme" extremes "x y" "max x y" [other "min x y"]),
    ("minimum", extreme "minimum" "maximum"),
    ("maximum", extreme "maximum" "minimum"),
    ("take", prefix "take" (takes "0") (takes "1")),
    ("drop", prefix "drop" (drops "0" "x") (drops "1" "(x Original.- 1)")),
    ("when", check "when" "x"),
    ("unless", check "unless" "Original.not x")
  ]
  where
    function name signature arguments text variants =
      Kind name signature arguments (original text) variants Nothing
    negated = [Variant "dropped" "x" always]
    extremes = "Original.Ord a => a -> a -> a"
    other text = Variant (takeWhile (/= ' ') text) (original text) "x Original./= y"
    extreme name opposite =
      function
        "extreme"
        "(Original.Foldable t, Original.Ord a) => t a -> a"
        "x"
        (name ++ " x")
        [ Variant
            opposite
            (original opposite ++ " x")
            (unwords [original name, "x Original./=", original opposite, "x"])
        ]
    prefix name more less =
      function
        "prefix"
        "Original.Int -> [a] -> [a]"
        "x y"
        (name ++ " x y")
        [ Variant "one more" (original name ++ " (x Original.+ 1) y") more,
          Variant "one less" (original name ++ " (x Original.- 1) y") less
        ]
    -- Of what is taken only the first element is known to be evaluated, if any is taken; of what is
    -- dropped it is known what is left.
    takes least = reaches least ++ "(x Original.== 0 Original.|| Original.not (Original.null y))"
    drops least count = reaches least ++ "Original.not (Original.null (" ++ dropped count ++ "))"
    reaches least = "x Original.>= " ++ least ++ " Original.&& "
    dropped count = "Original.drop " ++ count ++ " y"
    check name differs =
      function
        "check"
        "Original.Applicative f => Original.Bool -> f () -> f ()"
        "x y"
        (name ++ " x y")
        [Variant "passed over" "Original.pure ()" differs]

-- | A whole number.
number :: Kind
number =
  Kind
    "number"
    "Original.Num a => a -> a"
    "x"
    "x"
    [ Variant "one more" "x Original.+ 1" always,
      Variant "one less" "x Original.- 1" always
    ]
    Nothing

-- | A guard, or the condition of an @if@.
condition :: Kind
condition =
  Kind
    "condition"
    "Original.Bool -> Original.Bool"
    "x"
    "x"
    [ Variant "always" "Original.True" "Original.not x",
      Variant "never" "Original.False" "x"
    ]
    Nothing

-- | A function two of whose arguments are of one type, and stand side by side.
exchanged :: Kind
exchanged =
  Kind
    "exchange"
    "(a -> a -> b) -> a -> a -> b"
    "f x y"
    "f x y"
    [Variant "exchanged" "f y x" always]
    Nothing

-- | A list of this many elements, each of which may be dropped.
elements :: Int -> Kind
elements count =
  Kind
    "elements"
    "[a] -> [a]"
    "x"
    "x"
    [ Variant
        ("without the element " ++ show i)
        ("Original.take " ++ show (i - 1) ++ " x Original.++ Original.drop " ++ show i ++ " x")
        always
      | i <- [1 .. min 6 count]
    ]
    Nothing
