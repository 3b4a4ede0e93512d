{-# OPTIONS_HADDOCK hide #-}

-- | The stages of a decoder, which name and group the laws.
module PraTactile.Conformance.Stage
  ( Stage (..),
    stageName,
    codeStages,
    touchStages,
    objectStages,
    stagesApart,
  )
where

-- | The stages, in the order of writing a decoder.
data Stage
  = -- | How a process starts, keeps a profile and stops, independent of questions.
    OnProtocol
  | OnProfile
  | OnField
  | OnPolynomial
  | OnSequence
  | OnArray
  | OnWindow
  | OnProof
  | OnLocate
  | OnDamage
  | OnChances
  | -- | The stages of touch begin here.
    OnRegister
  | OnStitch
  | OnSegment
  | -- | The answers of a network to images.
    OnNetwork
  | -- | Solids, faces laid on an array, and poses.
    OnObjects
  deriving stock (Eq, Ord, Show, Enum, Bounded)

-- | The name of a stage, as for @--stage@.
stageName :: Stage -> String
stageName stage = case stage of
  OnProtocol -> "protocol"
  OnProfile -> "profile"
  OnField -> "field"
  OnPolynomial -> "polynomial"
  OnSequence -> "sequence"
  OnArray -> "array"
  OnWindow -> "window"
  OnProof -> "proof"
  OnLocate -> "locate"
  OnDamage -> "damage"
  OnChances -> "chances"
  OnRegister -> "register"
  OnStitch -> "stitch"
  OnSegment -> "segment"
  OnNetwork -> "network"
  OnObjects -> "objects"

-- | The stages of the code, including the protocol.
codeStages :: [Stage]
codeStages = [OnProtocol .. OnChances]

-- | The stages of touch.
touchStages :: [Stage]
touchStages = [OnRegister .. OnNetwork]

-- | The stage of objects.
objectStages :: [Stage]
objectStages = [OnObjects]

-- | The sets of stages that need no profile, with their names. They are tried only if requested.
stagesApart :: [(String, [Stage])]
stagesApart = [("touch", touchStages), (stageName OnObjects, objectStages)]
